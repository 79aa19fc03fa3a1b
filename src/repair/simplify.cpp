// Vertices where two lines end and nothing else is go where that moves nothing by more than the
// distance and sweeps over nothing, those that move least first.

#include <algorithm>
#include <set>

#include "diagnose/line_graph.hpp"
#include "geometry/box_tree.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// A vertex that may go, and the line that would take the place of two.
struct Corner {
  VertexId vertex;
  LineId first, second;
  Line line;
  Rational squared_size;
};

class Simplifying {
 public:
  Simplifying(Work& work, const Arranged& arranged, const Rational& distance)
      : work_(work),
        arranged_(arranged),
        complex_(arranged.complex),
        graph_(arranged.complex),
        squared_distance_(distance * distance),
        tree_(boxes(graph_)) {}

  void run() {
    std::vector<Corner> corners;
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
      if (std::optional<Corner> corner = corner_at(VertexId(v))) {
        corners.push_back(std::move(*corner));
      }
    }
    std::ranges::sort(corners, [](const Corner& c, const Corner& d) {
      const int by_size = cmp(c.squared_size, d.squared_size);
      return by_size != 0 ? by_size < 0 : c.vertex < d.vertex;
    });
    std::set<LineId> taken;  // the others are looked at anew when these are gone
    for (Corner& corner : corners) {
      if (taken.contains(corner.first) || taken.contains(corner.second)) continue;
      taken.insert(corner.first);
      taken.insert(corner.second);
      work_.apply(EditKind::Simplify, complex_.vertices[corner.vertex], corner.squared_size,
                  {corner.first, corner.second}, {std::move(corner.line)});
    }
  }

 private:
  static std::vector<BoxD> boxes(const diagnose_steps::LineGraph& graph) {
    std::vector<BoxD> result;
    for (const PointD& p : graph.rounded()) result.push_back(grown({p, p}, graph.slack()));
    return result;
  }

  std::optional<Corner> corner_at(VertexId v) const {
    if (graph_.degree(v) != 2) return std::nullopt;
    const auto lines = arranged_.lines(graph_.edges(v)[0]);
    const auto others = arranged_.lines(graph_.edges(v)[1]);
    if (lines.size() != 1 || others.size() != 1 || lines == others) return std::nullopt;
    const LineId first = lines.front(), second = others.front();
    if (work_.is_anchored(first) || work_.is_anchored(second) || work_.is_virtual(first) ||
        work_.is_virtual(second) || !work_.is_same_layer(first, second)) {
      return std::nullopt;
    }
    const Point p = complex_.vertices[v];
    const Line line = work_.line(first), other = work_.line(second);
    const Point a = line.a == p ? line.b : line.a, b = other.a == p ? other.b : other.a;
    if (a == b || sweeps(a, p, b)) return std::nullopt;
    Corner corner{v,
                  first,
                  second,
                  {std::min(a, b), std::max(a, b), united(line, other).segments},
                  squared_distance(p, a, b)};
    if (corner.squared_size > squared_distance_) return std::nullopt;
    for (const SegmentId s : corner.line.segments) {
      const Segment authored = work_.input().segments[s];
      for (const Point& end : {authored.a, authored.b}) {
        if (!is_beside(end, a, b)) continue;  // it has been cut off
        corner.squared_size = std::max(corner.squared_size, squared_distance(end, a, b));
      }
    }
    if (corner.squared_size <= squared_distance_) return corner;
    work_.refuse(EditKind::Simplify, p, std::move(corner.squared_size),
                 "lines would go further in all from where they were drawn than they may",
                 {first, second});
    return std::nullopt;
  }

  /// Whether the foot of p lies between a and b.
  static bool is_beside(const Point& p, const Point& a, const Point& b) {
    const auto along = [&](const Point& q) {
      return Rational((q.x - a.x) * (b.x - a.x) + (q.y - a.y) * (b.y - a.y));
    };
    return sgn(along(p)) >= 0 && along(p) <= along(b);
  }

  /// Whether there is a vertex in the triangle, corners excepted, or on the new line.
  bool sweeps(const Point& a, const Point& p, const Point& b) const {
    const std::array corners = {nearest(a), nearest(p), nearest(b)};
    const int turn = orientation(a, p, b);
    for (const std::size_t w : tree_.meeting(grown(box_of(corners), graph_.slack()))) {
      const Point q = complex_.vertices[w];
      if (q == a || q == p || q == b) continue;
      const bool is_in = turn * orientation(a, p, q) >= 0 && turn * orientation(p, b, q) >= 0 &&
                         turn * orientation(b, a, q) >= 0;
      if (turn == 0 ? on_segment(a, b, q) : is_in) return true;
    }
    return false;
  }

  Work& work_;
  const Arranged& arranged_;
  const ExactComplex& complex_;
  diagnose_steps::LineGraph graph_;
  Rational squared_distance_;
  BoxTree tree_;
};

}  // namespace

void simplify(Work& work, const Arranged& arranged, const Rational& distance) {
  Simplifying(work, arranged, distance).run();
}

}  // namespace plumbline::repair_steps
