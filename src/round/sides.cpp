// Rounding keeps the order of x and that of y, but for ties. So what is above or below an edge, its
// x between those of the ends, is there afterwards, too, and while all points move straight to
// their places; a vertex that has changed sides has met the edge on its way.
//
// It is enough to look at the edges next below and above each vertex in the exact complex. Say that
// none of them is passed, and take all edges below a vertex, one below the other. Neighbours
// among them have a vertex at or to the left of that x and one at or to the right between them (or
// at their ends), which stay between them; as their images do not cross, they are in order where
// the vertex is. So all of the edges stay below it.

#include "round/sides.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "complex/planarity.hpp"
#include "geometry/filtered_points.hpp"
#include "plumbline/error.hpp"

namespace plumbline::round_steps {
namespace {

class Sides {
 public:
  explicit Sides(const PointList& vertices) : points_(vertices) {
    column_.reserve(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const bool is_new = v == 0 || points_.rough(v - 1).x != points_.rough(v).x ||
                          vertices[v - 1].x != vertices[v].x;
      column_.push_back(v == 0 ? 0 : column_.back() + (is_new ? 1 : 0));
    }
  }

  /// Whether v is above all of the chain at its x (side 1), or below all of it (-1).
  bool is_beside(std::span<const VertexId> chain, VertexId v, int wanted) const {
    const std::uint32_t x = column_[v];
    if (chain.size() == 1) return column_[chain[0]] != x || side(chain[0], chain[0], v) == wanted;
    auto to = std::partition_point(chain.begin() + 1, chain.end() - 1,
                                   [&](VertexId w) { return column_[w] < x; });
    for (; to != chain.end() && column_[*std::prev(to)] <= x; ++to) {
      if (side(*std::prev(to), *to, v) != wanted) return false;
    }
    return true;
  }

 private:
  /// 1 if v is above the link from p to q, -1 if it is below it, else 0.
  int side(VertexId p, VertexId q, VertexId v) const {
    const auto [low, high] = std::minmax(p, q);
    if (column_[low] != column_[high]) return points_.orientation(low, high, v);
    return v > high ? 1 : v < low ? -1 : 0;
  }

  const FilteredPoints points_;
  std::vector<std::uint32_t> column_;  ///< per vertex, the number of smaller x
};

}  // namespace

std::optional<VertexId> vertex_past_edge(const ExactComplex& exact, const ExactComplex& rounded,
                                         const std::vector<VertexId>& vertex_image,
                                         const Lists<VertexId>& chains) {
  const auto beside = edges_beside_vertices(exact);
  ensure(beside.has_value(), "what is rounded is a valid complex");
  const Sides sides(rounded.vertices);
  for (std::size_t v = 0; v < beside->size(); ++v) {
    const auto [below, above] = (*beside)[v];
    const auto is_past = [&](EdgeId e, int wrong_side) {
      return e.valid() && sides.is_beside(chains[e], vertex_image[v], wrong_side);
    };
    if (is_past(below, -1) || is_past(above, 1)) return VertexId(v);
  }
  return std::nullopt;
}

}  // namespace plumbline::round_steps
