// Constrained Delaunay triangulation of the boundary edges of a face, then a flood fill from
// outside that changes sides at every one of them.

#include "plumbline/chains/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <type_traits>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
static_assert(std::is_same_v<Kernel::FT::ET, Rational>,
              "numbers cross to CGAL without conversion: link CGAL::CGAL, which selects mpq_class");

enum class Side { Unknown, Outside, Inside };
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexId, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Side, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// The edges with the face on one side only.
std::vector<EdgeId> boundary_of(const ExactComplex& complex, FaceId face) {
  std::vector<CycleId> cycles{complex.face_outer[face]};
  for (const CycleId hole : complex.face_holes[face]) cycles.push_back(hole);
  std::vector<EdgeId> edges;
  for (const CycleId c : cycles) {
    for (const HalfedgeId h : complex.cycles[c]) {
      if (!complex.is_antenna(edge_of(h))) edges.push_back(edge_of(h));
    }
  }
  return edges;
}

Triangulation triangulated(const ExactComplex& complex, const std::vector<EdgeId>& edges) {
  Triangulation triangulation;
  std::map<VertexId, Triangulation::Vertex_handle> handles;
  const auto handle = [&](VertexId v) {
    const auto [known, is_new] = handles.try_emplace(v);
    if (is_new) {
      const Point& p = complex.vertices[v];
      known->second = triangulation.insert({Kernel::FT(p.x), Kernel::FT(p.y)});
      known->second->info() = v;
    }
    return known->second;
  };
  for (const EdgeId e : edges) {
    const Edge& edge = complex.edges[e];
    const auto tail = handle(edge.tail), head = handle(edge.head);
    triangulation.insert_constraint(tail, head);
  }
  return triangulation;
}

/// Tells every triangle its side: outside is where infinity is.
void fill(Triangulation& triangulation) {
  for (const auto f : triangulation.all_face_handles()) f->info() = Side::Unknown;
  std::vector<Triangulation::Face_handle> reached{triangulation.infinite_face()};
  reached.front()->info() = Side::Outside;
  while (!reached.empty()) {
    const auto f = reached.back();
    reached.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto neighbour = f->neighbor(i);
      if (neighbour->info() != Side::Unknown) continue;
      const bool is_wall = triangulation.is_constrained({f, i});
      const Side other = f->info() == Side::Inside ? Side::Outside : Side::Inside;
      neighbour->info() = is_wall ? other : f->info();
      reached.push_back(neighbour);
    }
  }
}

Triangle triangle(Triangulation::Face_handle f) {
  Triangle result{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

std::vector<Triangle> triangulate(const ExactComplex& complex, FaceId face) {
  if (face == kUnbounded || face >= complex.face_count()) {
    throw Error(ErrorCode::BadInput, "only a bounded face can be triangulated", {},
                std::to_string(std::size_t{face}));
  }
  try {
    Triangulation triangulation = triangulated(complex, boundary_of(complex, face));
    fill(triangulation);
    std::vector<Triangle> triangles;
    for (const auto f : triangulation.finite_face_handles()) {
      if (f->info() == Side::Inside) triangles.push_back(triangle(f));
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw Error(ErrorCode::BadInput, "edges of the face cross: the complex is not valid");
  }
}

}  // namespace plumbline
