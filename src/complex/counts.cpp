#include <algorithm>

#include "plumbline/complex.hpp"

namespace plumbline {

Counts counts(const Incidences& complex, std::size_t vertex_count) {
  Counts result;
  result.vertices = vertex_count;
  result.edges = complex.edge_count();
  result.faces = complex.face_count();
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    result.holes += complex.face_holes[f].size();
  }
  result.isolated_vertices = complex.face_isolated_vertices.flat().size();
  result.components = complex.component_count();
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.is_antenna(EdgeId(e))) ++result.antennas;
  }
  for (const std::uint32_t depth : complex.face_depth) {
    result.depth = std::max<std::size_t>(result.depth, depth);
  }
  return result;
}

}  // namespace plumbline
