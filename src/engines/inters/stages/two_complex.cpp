// The 2-complex of non-intersecting cycles and boundaries of its chains, section 2.11
// (chain2BoundaryChain).

#include <algorithm>
#include <string>

#include "engines/inters/stages/cycle_vertices.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inters {

std::vector<VertexId> cycle_vertices(std::span<const VertexPair> edges) {
  HashTable<std::size_t> set;
  for (const VertexPair& edge : edges) {
    for (const VertexId v : edge) set.insert(v);
  }
  std::vector<VertexId> result;
  for (const std::size_t v : set.listed()) result.emplace_back(v);
  return result;
}

Model two_complex(const Model& lar, std::span<const std::vector<VertexPair>> cycles,
                  const CycleCells& cells) {
  Model result{lar.vertices, lar.edges, {}};
  for (const std::vector<std::size_t>& cell : cells) {
    std::vector<VertexId> face;
    for (const std::size_t cycle : cell) {
      const std::vector<VertexId> vertices = cycle_vertices(cycles[cycle]);
      face.insert(face.end(), vertices.begin(), vertices.end());
    }
    result.faces.push_back(face);
  }
  return result;
}

std::vector<std::size_t> boundary_chain(const Model& model, std::span<const std::size_t> faces) {
  std::vector<std::size_t> times(model.edges.size(), 0);
  for (const std::size_t f : faces) {
    if (f >= model.faces.size()) {
      throw Error(ErrorCode::BadInput, "a chain of faces has a face that the model has not", {},
                  std::to_string(f));
    }
    std::vector<bool> is_in_face(model.vertices.size(), false);
    for (const VertexId v : model.faces[f]) is_in_face[v] = true;
    for (std::size_t e = 0; e < model.edges.size(); ++e) {
      const auto& [v, w] = model.edges[e];
      if (is_in_face[v] && is_in_face[w]) ++times[e];
    }
  }
  std::vector<std::size_t> boundary;
  for (std::size_t e = 0; e < times.size(); ++e) {
    if (times[e] % 2 == 1) boundary.push_back(e);
  }
  return boundary;
}

}  // namespace plumbline::inters
