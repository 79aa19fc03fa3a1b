// The edges that name a segment as their source must tile it: each lies on it, and sorted along it
// they form a chain from one end to the other.

#include <algorithm>
#include <utility>

#include "complex/validate.hpp"

namespace plumbline {
namespace {

class Coverage {
 public:
  Coverage(const ExactComplex& complex, const SegmentSet& input) : c_(complex), input_(input) {}

  std::vector<Violation> check() {
    std::vector<std::vector<EdgeId>> edges(input_.segments.size());
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_sources[e].empty()) report("an edge has no source", EdgeId(e));
      for (const SegmentId s : c_.edge_sources[e]) {
        if (s < edges.size()) {
          edges[s].emplace_back(e);
        } else {
          report("an edge names a segment that is not in the input", EdgeId(e));
        }
      }
    }
    for (std::size_t s = 0; s < edges.size(); ++s) check_segment(SegmentId(s), edges[s]);
    for (const Point& p : input_.points) {
      if (std::binary_search(c_.vertices.begin(), c_.vertices.end(), p)) continue;
      violations_.add({Invariant::Coverage, "an input point is no vertex", p, {}, {}, {}});
    }
    return violations_.take();
  }

 private:
  /// Edges are sorted by (tail, head), so those on one segment come in order along it.
  void check_segment(SegmentId s, const std::vector<EdgeId>& edges) {
    const Segment segment = input_.segments[s];
    const auto& [first, last] = std::minmax(segment.a, segment.b);
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
