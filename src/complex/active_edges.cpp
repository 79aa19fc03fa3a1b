#include "complex/active_edges.hpp"

#include <algorithm>
#include <limits>

#include "complex/scan_line.hpp"

namespace plumbline {

std::vector<VertexId> least_vertices(const ExactComplex& complex) {
  std::vector<VertexId> least(complex.component_count());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    VertexId& first = least[complex.vertex_component[v]];
    if (!first.valid()) first = VertexId(v);
  }
  return least;
}

ActiveEdges::ActiveEdges(const ExactComplex& complex) : c_(complex) {
  for (std::size_t v = 0; v < c_.vertices.size(); ++v) y_.push_back(c_.vertices.nearest(v).y);
}

void ActiveEdges::advance(const Rational& x) {
  for (; next_ < c_.edge_count() && c_.vertices[c_.edges[next_].tail].x <= x; ++next_) {
    const auto [tail, head] = c_.edges[next_];
    const auto [low, high] = std::minmax(y_[tail], y_[head]);
    active_.push_back({EdgeId(next_), low, high});
  }
  std::erase_if(active_, [&](const Item& i) { return c_.vertices[c_.edges[i.edge].head].x <= x; });
}

std::optional<EdgeId> ActiveEdges::below(VertexId v) const {
  const Point& p = c_.vertices[v];
  const ScanLine line(c_, p.x);
  double floor = -std::numeric_limits<double>::infinity();  // some edge below v is nowhere lower
  for (const Item& i : active_) {
    if (i.high < y_[v]) floor = std::max(floor, i.low);
  }
  std::optional<EdgeId> highest;
  for (const Item& i : active_) {
    if (i.low > y_[v] || i.high < floor || !line.passes_below(i.edge, p)) continue;
    if (!highest || line.above(i.edge, *highest)) highest = i.edge;
  }
  return highest;
}

}  // namespace plumbline
