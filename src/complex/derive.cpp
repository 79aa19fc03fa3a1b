// Faces of cycles and halfedges, connected components with their parent faces, nesting depths.

#include "complex/derive.hpp"

#include "geometry/union_find.hpp"

namespace plumbline {
namespace {

void derive_faces(Incidences& c) {
  c.cycle_face.assign(c.cycles.size(), FaceId());
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    if (c.face_outer[f].valid()) c.cycle_face[c.face_outer[f]] = FaceId(f);
    for (const CycleId hole : c.face_holes[f]) c.cycle_face[hole] = FaceId(f);
  }
  c.halfedge_face.assign(2 * c.edges.size(), FaceId());
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    for (const HalfedgeId h : c.cycles[i]) c.halfedge_face[h] = c.cycle_face[i];
  }
}

/// Numbers the connected components of the graph by their least vertex.
void derive_components(Incidences& c, std::size_t vertex_count) {
  UnionFind sets(vertex_count);
  for (const Edge& e : c.edges) sets.unite(e.tail, e.head);
  std::size_t count = 0;
  c.vertex_component.resize(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const std::size_t least = sets.find(v);
    c.vertex_component[v] = least == v ? ComponentId(count++) : c.vertex_component[least];
  }
  c.component_parent.assign(count, kUnbounded);
}

void derive_parents(Incidences& c) {
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    for (const CycleId hole : c.face_holes[f]) {
      c.component_parent[c.vertex_component[c.origin(c.cycles[hole].front())]] = FaceId(f);
    }
    for (const VertexId v : c.face_isolated_vertices[f]) {
      c.component_parent[c.vertex_component[v]] = FaceId(f);
    }
  }
}

/// Depths from the unbounded face inwards. A face that is not reached (only in a complex that nests
/// in a circle) keeps depth 0.
void derive_depths(Incidences& c) {
  std::vector<std::vector<FaceId>> children(c.face_count());
  for (std::size_t f = 1; f < c.face_count(); ++f) children[c.parent(FaceId(f))].emplace_back(f);
  c.face_depth.assign(c.face_count(), 0);
  std::vector<FaceId> queue{kUnbounded};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const FaceId child : children[queue[i]]) {
      c.face_depth[child] = c.face_depth[queue[i]] + 1;
      queue.push_back(child);
    }
  }
}

}  // namespace

FaceId Incidences::parent(FaceId f) const {
  if (f == kUnbounded) return kUnbounded;
  return component_parent[vertex_component[origin(cycles[face_outer[f]].front())]];
}

void derive(Incidences& complex, std::size_t vertex_count) {
  derive_faces(complex);
  derive_components(complex, vertex_count);
  derive_parents(complex);
  derive_depths(complex);
}

}  // namespace plumbline
