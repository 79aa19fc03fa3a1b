// A component lies in the face that is just below its least vertex, as far as the other components
// are concerned: none of its own edges passes below that vertex. A scan line goes over the
// components from left to right and keeps the edges that it may still meet, unless a sweep over all
// vertices has told already what is below them.

#include "complex/active_edges.hpp"
#include "complex/scan_line.hpp"
#include "complex/validate.hpp"

namespace plumbline {
namespace {

using EdgesBelow = std::optional<std::vector<std::optional<EdgeId>>>;

/// The face that each component lies in, computed from the graph alone.
std::vector<FaceId> surrounding_faces(const ExactComplex& c, const EdgesBelow& below) {
  std::vector<FaceId> faces;
  if (below) {
    for (const std::optional<EdgeId>& e : *below) faces.push_back(face_above(c, e));
    return faces;
  }
  ActiveEdges edges(c);
  for (const VertexId v : least_vertices(c)) {
    edges.advance(c.vertices[v].x);
    faces.push_back(face_above(c, edges.below(v)));
  }
  return faces;
}

/// How many holes and isolated vertices place each component in a face.
std::vector<std::size_t> placements(const ExactComplex& c) {
  std::vector<std::size_t> count(c.component_count(), 0);
  for (const CycleId hole : c.face_holes.flat()) {
    ++count[c.vertex_component[c.origin(c.cycles[hole].front())]];
  }
  for (const VertexId v : c.face_isolated_vertices.flat()) ++count[c.vertex_component[v]];
  return count;
}

}  // namespace

void validate_nesting(const ExactComplex& complex, const EdgesBelow& below,
                      Violations& violations) {
  const std::vector<VertexId> least = least_vertices(complex);
  const std::vector<std::size_t> placed = placements(complex);
  const std::vector<FaceId> surrounding = surrounding_faces(complex, below);
  for (std::size_t k = 0; k < least.size(); ++k) {
    const auto report = [&](const std::string& message, std::vector<FaceId> faces) {
      violations.add({Invariant::Nesting,
                      message,
                      complex.vertices[least[k]],
                      {least[k]},
                      {},
                      std::move(faces)});
    };
    if (placed[k] != 1) {
      report("a component is the hole of " + std::to_string(placed[k]) + " faces, not of one", {});
    } else if (complex.component_parent[k] != surrounding[k]) {
      report("a component is a hole of another face than the one that it lies in",
             {complex.component_parent[k], surrounding[k]});
    }
  }
}

}  // namespace plumbline
