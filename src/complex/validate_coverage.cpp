// The edges that name a segment as their source must tile it: each lies on it, and sorted along it
// they form a chain from one end to the other. Edges are sorted by (tail, head), so those on one
// segment come in order along it, and all run the same way.

#include <algorithm>
#include <utility>

#include "complex/validate.hpp"
#include "geometry/stored.hpp"

namespace plumbline {
namespace {

/// Whether an edge on a line goes on along it into the next one, which begins where it ends,
/// decided once for each pair of them: where many segments lie on one line, they have the same
/// pairs.
class StraightOn {
 public:
  explicit StraightOn(const ExactComplex& complex) : c_(complex), next_(complex.edge_count()) {}

  /// Requires: e lies on the line through the segment.
  bool operator()(EdgeId e, EdgeId f, std::span<const Number, 4> segment) {
    const bool is_shared = c_.edge_sources[f].size() > 1;
    if (is_shared && next_[e] == f) return true;
    if (!is_on_line(c_.vertices, c_.edges[f].head, segment)) return false;
    if (is_shared) next_[e] = f;
    return true;
  }

 private:
  const ExactComplex& c_;
  std::vector<EdgeId> next_;  ///< per edge the one that it was found to go on into
};

/// The edges of a segment as far as they are known, one after the other along its line.
struct Walk {
  EdgeId last;
  VertexId reached;
  bool is_doubtful = false;
};

class Coverage {
 public:
  Coverage(const ExactComplex& complex, const SegmentSet& input) : c_(complex), input_(input) {}

  std::vector<Violation> check() {
    const std::vector<SegmentId> doubtful = doubtful_segments();
    const std::vector<std::vector<EdgeId>> edges = edges_of(doubtful);
    for (const SegmentId s : doubtful) check_segment(s, edges[s]);
    for (const Point& p : input_.points) {
      const std::size_t v = c_.vertices.count_before(p);
      if (v < c_.vertices.size() && c_.vertices[v] == p) continue;
      violations_.add({Invariant::Coverage, "an input point is no vertex", p, {}, {}, {}});
    }
    return violations_.take();
  }

 private:
  /// The segments of which a walk along the edges does not show that they are covered. Reports
  /// edges with sources that are none.
  std::vector<SegmentId> doubtful_segments() {
    const std::size_t count = input_.segments.size();
    std::vector<Walk> walks(count);
    StraightOn goes_straight_on(c_);
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      if (c_.edge_sources[e].empty()) report("an edge has no source", e);
      for (const SegmentId s : c_.edge_sources[e]) {
        if (s >= count) {
          report("an edge names a segment that is not in the input", e);
          continue;
        }
        Walk& walk = walks[s];
        if (walk.is_doubtful) continue;
        const auto segment = input_.segments.numbers(s);
        const bool goes_on = walk.last.valid() ? walk.reached == c_.edges[e].tail &&
                                                     goes_straight_on(walk.last, e, segment)
                                               : begins(e, segment);
        walk = {e, c_.edges[e].head, !goes_on};
      }
    }
    std::vector<SegmentId> doubtful;
    for (std::size_t s = 0; s < count; ++s) {
      const Walk& walk = walks[s];
      const bool is_covered =
          walk.last.valid() && !walk.is_doubtful && ends(walk.reached, input_.segments.numbers(s));
      if (!is_covered) doubtful.emplace_back(s);
    }
    return doubtful;
  }

  static bool runs_forward(std::span<const Number, 4> segment) {
    return segment[0] != segment[2] ? segment[0] < segment[2] : segment[1] < segment[3];
  }
  /// Whether e begins at the segment's first end and runs along its line.
  bool begins(EdgeId e, std::span<const Number, 4> segment) const {
    const auto end = runs_forward(segment) ? segment.first<2>() : segment.last<2>();
    return is_at(c_.vertices, c_.edges[e].tail, end[0], end[1]) &&
           is_on_line(c_.vertices, c_.edges[e].head, segment);
  }
  /// Whether v is the segment's last end.
  bool ends(VertexId v, std::span<const Number, 4> segment) const {
    const auto end = runs_forward(segment) ? segment.last<2>() : segment.first<2>();
    return is_at(c_.vertices, v, end[0], end[1]);
  }

  /// Per segment its edges, of the doubtful ones only.
  std::vector<std::vector<EdgeId>> edges_of(const std::vector<SegmentId>& doubtful) const {
    std::vector<std::vector<EdgeId>> edges(input_.segments.size());
    if (doubtful.empty()) return edges;
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      for (const SegmentId s : c_.edge_sources[e]) {
        if (std::binary_search(doubtful.begin(), doubtful.end(), s)) edges[s].emplace_back(e);
      }
    }
    return edges;
  }

  /// Says what is wrong with a doubtful one.
  void check_segment(SegmentId s, const std::vector<EdgeId>& edges) {
    const Segment segment = input_.segments[s];
    const auto [first, last] = std::minmax(segment.a, segment.b);
    Point reached = first;
    for (const EdgeId e : edges) {
      const Point &tail = c_.vertices[c_.edges[e].tail], &head = c_.vertices[c_.edges[e].head];
      if (!on_segment(first, last, tail) || !on_segment(first, last, head)) {
        report("an edge does not lie on its source", e);
      } else if (tail != reached) {
        report("the edges of a segment leave a gap or overlap", e);
      }
      reached = head;
    }
    if (reached != last) {
      violations_.add({Invariant::Coverage,
                       "the edges of segment " + std::to_string(s) + " do not reach its end",
                       last,
                       {},
                       edges,
                       {}});
    }
  }

  void report(const char* message, EdgeId e) {
    violations_.add({Invariant::Coverage, message, c_.vertices[c_.edges[e].tail], {}, {e}, {}});
  }

  const ExactComplex& c_;
  const SegmentSet& input_;
  Violations violations_;
};

}  // namespace

std::vector<Violation> validate_coverage(const ExactComplex& complex, const SegmentSet& input) {
  return Coverage(complex, input).check();
}

}  // namespace plumbline
