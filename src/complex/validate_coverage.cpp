// The edges that name a segment as their source must tile it: each lies on it, and sorted along it
// they form a chain from one end to the other. Edges are sorted by (tail, head), so those on one
// segment come in order along it, and all run the same way.

#include <algorithm>
#include <utility>

#include "complex/validate.hpp"

namespace plumbline {
namespace {

/// Whether an edge goes straight on into the next one, decided once for each pair of them: where
/// many segments lie on one line, they have the same pairs.
class StraightOn {
 public:
  explicit StraightOn(const ExactComplex& complex) : c_(complex), next_(complex.edge_count()) {}

  bool operator()(EdgeId e, EdgeId f) {
    if (c_.edges[e].head != c_.edges[f].tail) return false;
    if (next_[e] == f) return true;
    if (orientation(c_.vertices[c_.edges[e].tail], c_.vertices[c_.edges[e].head],
                    c_.vertices[c_.edges[f].head]) != 0)
      return false;
    next_[e] = f;
    return true;
  }

 private:
  const ExactComplex& c_;
  std::vector<EdgeId> next_;  ///< per edge the one that it was found to go on into
};

class Coverage {
 public:
  Coverage(const ExactComplex& complex, const SegmentSet& input) : c_(complex), input_(input) {}

  std::vector<Violation> check() {
    const std::vector<SegmentId> doubtful = doubtful_segments();
    const std::vector<std::vector<EdgeId>> edges = edges_of(doubtful);
    for (const SegmentId s : doubtful) check_segment(s, edges[s]);
    for (const Point& p : input_.points) {
      if (std::binary_search(c_.vertices.begin(), c_.vertices.end(), p)) continue;
      violations_.add({Invariant::Coverage, "an input point is no vertex", p, {}, {}, {}});
    }
    return violations_.take();
  }

 private:
  /// The segments of which a walk along the edges does not show that they are covered. Reports
  /// edges with sources that are none.
  std::vector<SegmentId> doubtful_segments() {
    const std::size_t count = input_.segments.size();
    std::vector<EdgeId> last(count);  // of the chain so far
    std::vector<bool> is_doubtful(count, false);
    StraightOn goes_straight_on(c_);
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      if (c_.edge_sources[e].empty()) report("an edge has no source", e);
      for (const SegmentId s : c_.edge_sources[e]) {
        if (s >= count) {
          report("an edge names a segment that is not in the input", e);
          continue;
        }
        if (last[s].valid() && !goes_straight_on(last[s], e)) is_doubtful[s] = true;
        if (!last[s].valid() && c_.vertices[c_.edges[e].tail] != ends(s).first)
          is_doubtful[s] = true;
        last[s] = e;
      }
    }
    std::vector<SegmentId> doubtful;
    for (std::size_t s = 0; s < count; ++s) {
      const bool is_reached =
          last[s].valid() && c_.vertices[c_.edges[last[s]].head] == ends(SegmentId(s)).second;
      if (is_doubtful[s] || !is_reached) doubtful.emplace_back(s);
    }
    return doubtful;
  }

  std::pair<Point, Point> ends(SegmentId s) const {
    const Segment segment = input_.segments[s];
    return std::minmax(segment.a, segment.b);
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
    const auto [first, last] = ends(s);
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
