// A LAR model over merged vertices, section 2.9 (larSimplify).

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "engines/lar/stages/check_model.hpp"
#include "engines/lar/stages/points.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::lar {
namespace {

std::vector<VertexPair> merged_edges(const Model& model, std::span<const VertexId> vertex_map) {
  std::vector<VertexPair> edges;
  for (const auto& [v, w] : model.edges) {
    const auto [tail, head] = std::minmax(vertex_map[v], vertex_map[w]);
    if (tail != head) edges.push_back({tail, head});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Faces are equal if they have the same vertices.
std::vector<std::vector<VertexId>> merged_faces(const Model& model,
                                                std::span<const VertexId> vertex_map) {
  std::vector<std::vector<VertexId>> faces;
  std::set<std::set<VertexId>> known;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    std::vector<VertexId> face;
    std::set<VertexId> distinct;
    for (const VertexId v : model.faces[f]) {
      if (distinct.insert(vertex_map[v]).second) face.push_back(vertex_map[v]);
    }
    if (face.size() >= 3 && known.insert(distinct).second) faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace

void check_cells(const Model& model) {
  const auto check = [&](VertexId v) {
    if (v < model.vertices.size()) return;
    throw Error(ErrorCode::BadInput, "a cell has a vertex that the model has not", {},
                std::to_string(std::size_t{v}));
  };
  for (const VertexPair& edge : model.edges) std::for_each(edge.begin(), edge.end(), check);
  for (const VertexId v : model.faces.flat()) check(v);
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (!model.faces[f].empty()) continue;
    throw Error(ErrorCode::BadInput, "a face has no vertex", {}, std::to_string(f));
  }
}

Model simplify(const Model& model, double radius) {
  check_cells(model);
  if (!(std::isfinite(radius) && radius >= 0)) {
    throw Error(ErrorCode::BadInput, "the radius must be finite and not negative", {},
                shortest_text(radius));
  }
  const double least = kLeastRelativeRadius * largest_coordinate(model.vertices);
  const double raised = std::max(radius, least);
  const Pruning pruning = prune_vertices(model.vertices, raised > 0 ? raised : 1);
  Model result{{}, merged_edges(model, pruning.vertex_map), {}};
  std::vector<std::vector<VertexId>> faces = merged_faces(model, pruning.vertex_map);

  std::vector<VertexId> renumbered(pruning.vertices.size());
  for (const VertexPair& edge : result.edges) {
    for (const VertexId v : edge) renumbered[v] = v;
  }
  for (const auto& face : faces) {
    for (const VertexId v : face) renumbered[v] = v;
  }
  for (std::size_t v = 0; v < renumbered.size(); ++v) {
    if (!renumbered[v].valid()) continue;
    renumbered[v] = VertexId(result.vertices.size());
    result.vertices.push_back(pruning.vertices[v]);
  }
  for (VertexPair& edge : result.edges) edge = {renumbered[edge[0]], renumbered[edge[1]]};
  for (auto& face : faces) {
    for (VertexId& v : face) v = renumbered[v];
    result.faces.push_back(face);
  }
  return result;
}

}  // namespace plumbline::lar
