// Sites are vertices further apart than the distance, chosen greedily: those of anchored lines
// first, then those with the most edges. Every other vertex goes to the nearest site. An edge leads
// over the sites that are nearest to it one after the other, of those within the distance of it
// (the planar rule of Google's S2Builder).

#include <algorithm>
#include <map>

#include "diagnose/line_graph.hpp"
#include "geometry/point_tree.hpp"
#include "repair/path.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

class Snapping {
 public:
  Snapping(Work& work, const Arranged& arranged, const Rational& distance)
      : work_(work),
        arranged_(arranged),
        complex_(arranged.complex),
        graph_(arranged.complex),
        squared_distance_(distance * distance),
        radius_(nearest_double(distance) * (1 + 0x1p-20) + 2 * graph_.slack()),
        tree_(graph_.rounded()),
        site_of_(complex_.vertices.size()) {}

  void run() {
    choose_sites();
    std::map<LineId, std::vector<VertexId>> paths;  // over sites
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const std::vector<VertexId> path = path_of(EdgeId(e));
      for (const LineId id : arranged_.lines(EdgeId(e))) {
        std::vector<VertexId>& whole = paths[id];
        whole.insert(whole.end(), path.begin(), path.end());
      }
    }
    std::vector<std::pair<std::vector<VertexId>, LineId>> ordered;
    for (auto& [id, path] : paths) ordered.emplace_back(std::move(path), id);
    std::ranges::sort(ordered);
    for (const auto& [path, id] : ordered) move(id, path);
  }

 private:
  bool is_within(VertexId v, VertexId w) const {
    return squared_distance(complex_.vertices[v], complex_.vertices[w]) <= squared_distance_;
  }

  void choose_sites() {
    std::vector<char> is_anchored(complex_.vertices.size());
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const std::vector<LineId> lines = arranged_.lines(EdgeId(e));
      if (std::ranges::none_of(lines, [&](LineId id) { return work_.is_anchored(id); })) continue;
      is_anchored[complex_.edges[e].tail] = is_anchored[complex_.edges[e].head] = 1;
    }
    std::vector<VertexId> order;
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) order.emplace_back(v);
    std::ranges::stable_sort(order, [&](VertexId v, VertexId w) {
      if (is_anchored[v] != is_anchored[w]) return is_anchored[v] != 0;
      return graph_.degree(v) > graph_.degree(w);
    });
    std::vector<char> is_site(complex_.vertices.size());
    for (const VertexId v : order) {
      bool is_near_site = false;
      tree_.for_each_near(graph_.rounded(v), radius_, [&](std::size_t w) {
        is_near_site = is_near_site || (is_site[w] != 0 && is_within(v, VertexId(w)));
      });
      is_site[v] = is_anchored[v] != 0 || !is_near_site ? 1 : 0;
    }
    for (const VertexId v : order) site_of_[v] = is_site[v] != 0 ? v : nearest_site(v, is_site);
    is_site_ = std::move(is_site);
  }

  VertexId nearest_site(VertexId v, const std::vector<char>& is_site) const {
    std::vector<std::pair<Rational, VertexId>> near;
    tree_.for_each_near(graph_.rounded(v), radius_, [&](std::size_t w) {
      if (is_site[w] == 0) return;
      near.emplace_back(squared_distance(complex_.vertices[v], complex_.vertices[VertexId(w)]), w);
    });
    return std::ranges::min(near).second;
  }

  /// A site near an edge: its squared distance from the point at parameter t is a common part and
  /// `offset` - t `slope`.
  struct Near {
    VertexId site;
    Rational slope, offset;
  };

  /// The sites that an edge leads over, from its tail to its head.
  std::vector<VertexId> path_of(EdgeId e) const {
    const Edge& edge = complex_.edges[e];
    const VertexId first = site_of_[edge.tail], last = site_of_[edge.head];
    const PointD &p = graph_.rounded(edge.tail), &q = graph_.rounded(edge.head);
    const PointD middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    std::vector<VertexId> sites = {first, last};
    tree_.for_each_near(middle, graph_.approx_length(e) / 2 + radius_, [&](std::size_t w) {
      if (is_site_[w] != 0 && is_beside(VertexId(w), edge)) sites.emplace_back(w);
    });
    if (sites.size() == 2) return sites;
    const Point a = complex_.vertices[edge.tail], b = complex_.vertices[edge.head];
    std::vector<Near> near;
    for (const VertexId w : sites) {
      const Point s = complex_.vertices[w];
      near.push_back(
          {w, 2 * ((b.x - a.x) * (s.x - a.x) + (b.y - a.y) * (s.y - a.y)), squared_distance(a, s)});
    }
    return in_order(std::move(near), first, last);
  }
  bool is_beside(VertexId w, const Edge& edge) const {
    return squared_distance(complex_.vertices[w], complex_.vertices[edge.tail],
                            complex_.vertices[edge.head]) <= squared_distance_ / 4;
  }

  /// The lower envelope of offset - t slope, for t from 0 to 1.
  static std::vector<VertexId> in_order(std::vector<Near> near, VertexId first, VertexId last) {
    std::vector<VertexId> path = {first};
    Rational t = 0;
    const auto at = [&](VertexId site) -> const Near& {
      return *std::ranges::find(near, site, &Near::site);
    };
    while (path.back() != last) {
      const Near& now = at(path.back());
      const Near* next = nullptr;
      Rational meets;
      for (const Near& other : near) {
        if (!(other.slope > now.slope)) continue;
        Rational u = (other.offset - now.offset) / (other.slope - now.slope);
        if (u < t || u > 1) continue;
        if (next == nullptr || u < meets || (u == meets && other.slope > next->slope)) {
          next = &other;
          meets = std::move(u);
        }
      }
      if (next == nullptr) break;
      path.push_back(next->site);
      t = meets;
    }
    if (path.back() != last) path.push_back(last);
    return path;
  }

  void move(LineId id, const std::vector<VertexId>& path) {
    std::vector<Point> points;
    for (const VertexId v : path) points.push_back(complex_.vertices[v]);
    const Line line = work_.line(id);
    std::vector<Line> after = lines_along(points, line.segments);
    if (work_.is_anchored(id) || (after.size() == 1 && after.front() == line)) return;
    Rational squared_size = 0;
    for (std::size_t v = 0; v < 2; ++v) {
      const Point& end = v == 0 ? line.a : line.b;
      const Point& to = v == 0 ? points.front() : points.back();
      squared_size = std::max(squared_size, squared_distance(end, to));
    }
    for (const Point& p : points) {
      squared_size = std::max(squared_size, squared_distance(p, line.a, line.b));
    }
    work_.apply(EditKind::Snap, line.a, squared_size, {id}, std::move(after));
  }

  Work& work_;
  const Arranged& arranged_;
  const ExactComplex& complex_;
  diagnose_steps::LineGraph graph_;
  Rational squared_distance_;
  double radius_;
  PointTree tree_;
  std::vector<VertexId> site_of_;
  std::vector<char> is_site_;
};

}  // namespace

void snap(Work& work, const Arranged& arranged, const Rational& distance) {
  Snapping(work, arranged, distance).run();
}

}  // namespace plumbline::repair_steps
