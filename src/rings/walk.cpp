#include "rings/walk.hpp"

#include <algorithm>

namespace plumbline::rings {

Walks::Walks(const SegmentSet& input, const ExactComplex& complex)
    : input_(input), complex_(complex), begin_(input.segments.size() + 1) {
  std::vector<bool> is_of_ring(input.segments.size());
  for (const Ring& ring : input.rings) {
    for (std::size_t i = 0; i < ring.count; ++i) is_of_ring[ring.first + i] = true;
  }
  const auto visit = [&](auto&& look_at) {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      for (const SegmentId s : complex.edge_sources[e]) {
        if (is_of_ring[s]) look_at(s, EdgeId(e));
      }
    }
  };
  visit([&](SegmentId s, EdgeId) { ++begin_[s + 1]; });
  for (std::size_t s = 1; s < begin_.size(); ++s) begin_[s] += begin_[s - 1];
  edges_.resize(begin_.back());
  std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
  visit([&](SegmentId s, EdgeId e) { edges_[end[s]++] = e; });
}

Walk Walks::of(std::size_t index) const {
  const Ring& ring = input_.rings[index];
  Walk walk{index, ring.role, true, {}, {}};
  const auto point = [&](std::size_t s, std::size_t end) {
    const auto n = input_.segments.numbers(s);
    return NumberPoint{n[2 * end], n[2 * end + 1]};
  };
  for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
    const NumberPoint a = point(s, 0), b = point(s, 1);
    const bool is_forth = a.x != b.x ? a.x < b.x : a.y < b.y;
    const auto first = edges_.begin() + begin_[s], last = edges_.begin() + begin_[s + 1];
    // Edges, and vertices, ascend along a segment from its lesser end.
    const auto add = [&](EdgeId e) {
      const Edge& edge = complex_.edges[e];
      walk.vertices.push_back(is_forth ? edge.tail : edge.head);
      walk.edges.push_back(e);
    };
    if (is_forth) {
      std::for_each(first, last, add);
    } else {
      std::for_each(std::reverse_iterator(last), std::reverse_iterator(first), add);
    }
  }
  const std::size_t last = ring.first + ring.count - 1;
  walk.is_closed = ring.count > 0 && point(last, 1) == point(ring.first, 0);
  if (!walk.is_closed && !walk.edges.empty()) {
    const Edge& edge = complex_.edges[walk.edges.back()];
    walk.vertices.push_back(edge.tail == walk.vertices.back() ? edge.head : edge.tail);
  }
  return walk;
}

}  // namespace plumbline::rings
