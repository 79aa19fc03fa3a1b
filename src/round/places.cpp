#include "round/places.hpp"

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::round_steps {

Places distinct(std::vector<Point> places) {
  Places result;
  result.of_vertex.resize(places.size());
  result.points.reserve(places.size());
  std::vector<VertexId> column;  // vertices of equal x
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    column.clear();
    for (end = begin; end < places.size() && places[end].x == places[begin].x; ++end) {
      column.emplace_back(end);
    }
    ensure(end == places.size() || places[begin].x < places[end].x, "rounding is monotone");
    std::stable_sort(column.begin(), column.end(),
                     [&](VertexId v, VertexId w) { return places[v].y < places[w].y; });
    const std::size_t first = result.points.size();
    for (const VertexId v : column) {
      if (result.points.size() == first || places[v].y != result.points.back().y) {
        result.points.push_back(places[v]);
      }
      result.of_vertex[v] = VertexId(result.points.size() - 1);
    }
  }
  return result;
}

}  // namespace plumbline::round_steps
