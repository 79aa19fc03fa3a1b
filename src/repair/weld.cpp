// Carriers go onto stronger ones beside them. Then all vertices of the arrangement on what moves go
// to where the carriers that meet in them meet now: so nothing that touched comes apart.

#include <algorithm>
#include <map>
#include <set>

#include "repair/carriers.hpp"
#include "repair/path.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// The part of a line that a carrier and what has gone onto it cover, as parameters of c.
struct Interval {
  Rational low, high;
};
Rational parameter(const Carrier& c, const Point& p) {
  return ((p.x - c.a.x) * (c.b.x - c.a.x) + (p.y - c.a.y) * (c.b.y - c.a.y)) / c.squared_length;
}
Interval interval(const Carrier& c, const Carrier& of) {
  const Rational t = parameter(c, of.a), u = parameter(c, of.b);
  return {std::min(t, u), std::max(t, u)};
}

class Welding {
 public:
  /// Looks at lines from `first_new` on, and what is on carriers with them.
  Welding(Work& work, const Arranged& arranged, const Rational& distance, LineId first_new,
          const std::set<SegmentId>& stays)
      : work_(work),
        stays_(stays),
        arranged_(arranged),
        complex_(arranged.complex),
        squared_distance_(distance * distance),
        all_(work, arranged) {
    for (const auto& [i, j] : side_by_side(work, arranged, distance, all_.are_new(first_new))) {
      const std::size_t c = all_.of_line(i), d = all_.of_line(j);
      if (c == d) continue;
      beside_[c].push_back(d);
      beside_[d].push_back(c);
    }
  }

  void run() {
    choose();
    move_vertices();
    move_lines();
  }

  std::vector<Rational> squared_offsets() {
    choose();
    std::vector<Rational> result;
    for (const auto& [d, c] : onto_) {
      result.push_back(std::max(squared_distance_from(carrier(c), carrier(d).a),
                                squared_distance_from(carrier(c), carrier(d).b)));
    }
    return result;
  }

 private:
  const Carrier& carrier(std::size_t i) { return all_[i]; }
  /// Where it goes, or itself.
  std::size_t final(std::size_t i) const {
    const auto found = onto_.find(i);
    return found == onto_.end() ? i : found->second;
  }

  /// The strongest carriers first take the weaker ones beside them, and what is beside those.
  void choose() {
    std::vector<std::size_t> order;
    for (const auto& [i, near] : beside_) order.push_back(i);
    std::ranges::sort(
        order, [&](std::size_t i, std::size_t j) { return is_stronger(carrier(i), carrier(j)); });
    std::set<std::size_t> settled;
    for (const std::size_t c : order) {
      if (!settled.insert(c).second) continue;
      Interval covered{0, 1};
      std::vector<std::size_t> near = beside_[c];
      for (bool again = true; again;) {
        again = false;
        std::ranges::sort(near);
        near.erase(std::unique(near.begin(), near.end()), near.end());
        const std::vector<std::size_t> tried = near;
        for (const std::size_t d : tried) {
          if (settled.contains(d) || !fits(carrier(c), carrier(d), covered)) continue;
          settled.insert(d);
          onto_[d] = c;
          const Interval more = interval(carrier(c), carrier(d));
          covered = {std::min(covered.low, more.low), std::max(covered.high, more.high)};
          near.insert(near.end(), beside_[d].begin(), beside_[d].end());
          again = true;
        }
      }
    }
  }

  /// Whether d may go onto c: as it is and as it was authored it lies within the distance, beside
  /// what c covers for more than the distance, and neither is part of a curve or as small a detail.
  bool fits(const Carrier& c, const Carrier& d, const Interval& covered) {
    if (d.is_anchored || d.squared_length <= 4 * squared_distance_) return false;
    const Interval own = interval(c, d);
    const Rational both = std::min(own.high, covered.high) - std::max(own.low, covered.low);
    if (sgn(both) <= 0 || both * both * c.squared_length <= squared_distance_) return false;
    if (!is_near(c, d.a) || !is_near(c, d.b) || stays(d)) return false;
    if (c.is_curved || d.is_curved) return false;
    for (const LineId id : d.lines) {
      for (const SegmentId s : work_.line(id).segments) {
        const Segment authored = work_.input().segments[s];
        if (is_near_or_cut_off(c, d, authored.a) && is_near_or_cut_off(c, d, authored.b)) continue;
        work_.refuse(
            EditKind::Weld, d.a,
            std::max(squared_distance_from(c, authored.a), squared_distance_from(c, authored.b)),
            "it would go further in all from where it was drawn than it may", d.lines);
        return false;
      }
    }
    return true;
  }
  /// Whether an end of a segment that d stands for is near c, or not beside d any more.
  bool is_near_or_cut_off(const Carrier& c, const Carrier& d, const Point& p) const {
    const Rational t = parameter(d, p);
    return t < 0 || t > 1 || is_near(c, p);
  }
  bool stays(const Carrier& c) const {
    return std::ranges::any_of(c.lines, [&](LineId id) {
      return std::ranges::any_of(work_.line(id).segments,
                                 [&](SegmentId s) { return stays_.contains(s); });
    });
  }
  bool is_near(const Carrier& c, const Point& p) const {
    return squared_distance_from(c, p) <= squared_distance_;
  }

  /// Images of the vertices on what moves.
  void move_vertices() {
    if (onto_.empty()) return;
    std::map<VertexId, std::vector<std::size_t>> through;  // final carriers
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      if (!onto_.contains(all_.of_edge(EdgeId(e)))) continue;
      through[complex_.edges[e].tail];
      through[complex_.edges[e].head];
    }
    if (through.empty()) return;
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      for (const VertexId v : {complex_.edges[e].tail, complex_.edges[e].head}) {
        const auto found = through.find(v);
        if (found != through.end()) found->second.push_back(final(all_.of_edge(EdgeId(e))));
      }
    }
    for (auto& [v, carriers] : through) {
      std::ranges::sort(carriers, [&](std::size_t i, std::size_t j) {
        return is_stronger(carrier(i), carrier(j));
      });
      carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
      image_.emplace(v, image(complex_.vertices[v], carriers));
    }
  }

  /// Where the strongest carrier through v meets the next strong one, no further away than twice
  /// the distance; else its foot. What is anchored stays as it is.
  Point image(const Point& v, std::vector<std::size_t> carriers) {
    const auto others = std::stable_partition(carriers.begin(), carriers.end(), [&](std::size_t c) {
      return carrier(c).is_anchored && has(c, v);
    });
    const auto anchors = static_cast<std::size_t>(others - carriers.begin());
    if (anchors > 1 || (anchors == 1 && is_anchored_end(v, carriers.front()))) return v;
    const Carrier& first = carrier(carriers.front());
    for (std::size_t i = 1; i < carriers.size(); ++i) {
      const std::optional<Point> p = meeting(first, carrier(carriers[i]));
      if (p && squared_distance(*p, v) <= 4 * squared_distance_ &&
          (anchors == 0 || stays_on_anchored(carriers.front(), v, *p))) {
        return *p;
      }
    }
    return anchors == 0 ? foot(first, v) : v;
  }
  /// Whether p is on all anchored lines of a carrier that have v.
  bool stays_on_anchored(std::size_t c, const Point& v, const Point& p) {
    return std::ranges::all_of(carrier(c).lines, [&](LineId id) {
      const Line line = work_.line(id);
      return !work_.is_anchored(id) || !on_segment(line.a, line.b, v) ||
             on_segment(line.a, line.b, p);
    });
  }
  bool has(std::size_t c, const Point& p) { return on_segment(carrier(c).a, carrier(c).b, p); }
  /// Whether an anchored line ends there.
  bool is_anchored_end(const Point& p, std::size_t c) {
    return std::ranges::any_of(carrier(c).lines, [&](LineId id) {
      const Line line = work_.line(id);
      return work_.is_anchored(id) && (line.a == p || line.b == p);
    });
  }

  /// Lines lead over the images of their vertices.
  void move_lines() {
    if (image_.empty()) return;
    std::map<LineId, std::vector<VertexId>> vertices;
    std::vector<char> moves(arranged_.line_of.size());
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const Edge& edge = complex_.edges[e];
      if (!image_.contains(edge.tail) && !image_.contains(edge.head)) continue;
      for (const SegmentId s : complex_.edge_sources[e]) moves[s] = 1;
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      for (const SegmentId s : complex_.edge_sources[e]) {
        if (moves[s] == 0) continue;
        std::vector<VertexId>& on_line = vertices[arranged_.line_of[s]];
        if (on_line.empty()) on_line.push_back(complex_.edges[e].tail);
        on_line.push_back(complex_.edges[e].head);
      }
    }
    std::vector<std::pair<LineId, std::vector<VertexId>>> ordered(vertices.begin(), vertices.end());
    std::ranges::sort(ordered, [](const auto& p, const auto& q) { return p.second < q.second; });
    for (const auto& [id, on_line] : ordered) move(id, on_line);
  }

  void move(LineId id, const std::vector<VertexId>& on_line) {
    std::vector<Point> path;
    Rational squared_size = 0;
    for (const VertexId v : on_line) {
      const Point from = complex_.vertices[v];
      const auto moved = image_.find(v);
      const Point& to = moved == image_.end() ? from : moved->second;
      squared_size = std::max(squared_size, squared_distance(from, to));
      path.push_back(to);
    }
    const Line line = work_.line(id);
    const bool stays =
        path.front() == line.a && path.back() == line.b &&
        std::ranges::all_of(path, [&](const Point& p) { return on_segment(line.a, line.b, p); });
    if (stays) return;
    std::vector<Line> after = lines_along(path, line.segments);
    work_.apply(EditKind::Weld, line.a, squared_size, {id}, std::move(after));
  }

  Work& work_;
  std::set<SegmentId> stays_;
  const Arranged& arranged_;
  const ExactComplex& complex_;
  Rational squared_distance_;
  Carriers all_;
  std::map<std::size_t, std::size_t> onto_;  ///< of what moves, the carrier that it goes onto
  std::map<std::size_t, std::vector<std::size_t>> beside_;
  std::map<VertexId, Point> image_;
};

}  // namespace

std::vector<Rational> weld_offsets(Work& work, const Arranged& arranged, const Rational& distance) {
  return Welding(work, arranged, distance, kFirstLine, {}).squared_offsets();
}

void weld(Work& work, const Arranged& arranged, const Rational& distance, LineId first_new,
          const std::set<SegmentId>& stays) {
  if (first_new != kFirstLine && first_new >= work.count()) return;
  Welding(work, arranged, distance, first_new, stays).run();
}

}  // namespace plumbline::repair_steps
