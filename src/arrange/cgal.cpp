// The reference engine, and everything of CGAL that the library instantiates. Short and obvious,
// never tuned. Only aggregated `insert` is used: CGAL 5.5's `compute_subcurves` returns wrong
// answers.

#include "plumbline/cgal.hpp"

#include <CGAL/Arr_naive_point_location.h>

#include <algorithm>
#include <map>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "arrange/cgal_engine.hpp"
#include "plumbline/error.hpp"
#include "plumbline/polygons.hpp"

namespace plumbline {

static_assert(std::is_same_v<cgal::Kernel::FT::ET, Rational>,
              "numbers cross to CGAL without conversion: link CGAL::CGAL, which selects mpq_class");

namespace cgal {
namespace {

/// Per segment the first one with the same ends, in either direction.
std::vector<SegmentId> first_copies(const SegmentSet& input) {
  std::map<std::pair<Point, Point>, SegmentId> known;
  std::vector<SegmentId> first;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto& [a, b] = input.segments[s];
    first.push_back(known.try_emplace(std::minmax(a, b), SegmentId(s)).first->second);
  }
  return first;
}

/// Ids of the cells of an arrangement, by their addresses.
class Conversion {
 public:
  Conversion(const Arrangement& arrangement, const SegmentSet& input)
      : arrangement_(arrangement), copies_(input.segments.size()) {
    const std::vector<SegmentId> first = first_copies(input);
    for (std::size_t s = 0; s < first.size(); ++s) copies_[first[s]].emplace_back(s);
  }

  ExactComplex convert() {
    add_vertices();
    add_edges();
    // The unbounded face comes first.
    add_face(arrangement_.unbounded_face());
    for (auto f = arrangement_.faces_begin(); f != arrangement_.faces_end(); ++f) {
      if (!f->is_unbounded()) add_face(f);
    }
    return canonical(std::move(complex_));
  }

 private:
  void add_vertices() {
    for (auto v = arrangement_.vertices_begin(); v != arrangement_.vertices_end(); ++v) {
      vertex_[&*v] = VertexId(complex_.vertices.size());
      complex_.vertices.push_back(from_cgal(v->point()));
    }
  }

  void add_edges() {
    for (auto e = arrangement_.edges_begin(); e != arrangement_.edges_end(); ++e) {
      const EdgeId id(complex_.edges.size());
      halfedge_[&*e] = halfedge(id, false);
      halfedge_[&*e->twin()] = halfedge(id, true);
      complex_.edges.push_back({vertex_.at(&*e->source()), vertex_.at(&*e->target())});
      std::vector<SegmentId> sources;
      for (const SegmentId s : e->curve().data()) {
        sources.insert(sources.end(), copies_[s].begin(), copies_[s].end());
      }
      complex_.edge_sources.push_back(sources);
    }
  }

  template <class Circulator>
  CycleId add_cycle(Circulator first) {
    std::vector<HalfedgeId> cycle;
    Circulator h = first;
    do {
      cycle.push_back(halfedge_.at(&*h));
    } while (++h != first);
    complex_.cycles.push_back(cycle);
    return CycleId(complex_.cycles.size() - 1);
  }

  void add_face(Arrangement::Face_const_handle face) {
    complex_.face_outer.push_back(face->has_outer_ccb() ? add_cycle(face->outer_ccb()) : CycleId());
    std::vector<CycleId> holes;
    for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
      holes.push_back(add_cycle(*hole));
    }
    complex_.face_holes.push_back(holes);
    std::vector<VertexId> isolated;
    for (auto v = face->isolated_vertices_begin(); v != face->isolated_vertices_end(); ++v) {
      isolated.push_back(vertex_.at(&*v));
    }
    complex_.face_isolated_vertices.push_back(isolated);
  }

  const Arrangement& arrangement_;
  std::vector<std::vector<SegmentId>> copies_;  ///< per first copy, all segments equal to it
  ExactComplex complex_;
  std::unordered_map<const void*, VertexId> vertex_;
  std::unordered_map<const void*, HalfedgeId> halfedge_;
};

}  // namespace

Kernel::Point_2 to_cgal(const Point& p) {
  if (!is_within_limit(p)) {
    throw Error(ErrorCode::Limit, "a coordinate is beyond what CGAL's intervals hold", {},
                to_text(p));
  }
  return {Kernel::FT(p.x), Kernel::FT(p.y)};
}

Kernel::Segment_2 to_cgal(const Segment& s) { return {to_cgal(s.a), to_cgal(s.b)}; }

Point from_cgal(const Kernel::Point_2& p) {
  const auto& exact = CGAL::exact(p);  // lives as long as p
  return {exact.x(), exact.y()};
}

Point from_cgal(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_2& p) {
  return {rational_from(p.x()), rational_from(p.y())};
}

Arrangement arrangement(const SegmentSet& input) {
  std::vector<Traits::Curve_2> curves;
  curves.reserve(input.segments.size());
  // CGAL's sweep takes cubic time in the number of copies of a segment.
  const std::vector<SegmentId> first = first_copies(input);
  for (std::size_t s = 0; s < first.size(); ++s) {
    if (first[s] == SegmentId(s)) curves.emplace_back(to_cgal(input.segments[s]), SegmentId(s));
  }
  Arrangement result;
  CGAL::insert(result, curves.begin(), curves.end());
  // Not by the default walk along a line, which never ends for some points above a vertex.
  const CGAL::Arr_naive_point_location<Arrangement> location(result);
  for (const Point& p : input.points) CGAL::insert_point(result, to_cgal(p), location);
  return result;
}

ExactComplex to_complex(const Arrangement& arrangement, const SegmentSet& input) {
  return Conversion(arrangement, input).convert();
}

std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons(const ExactComplex& complex) {
  const auto polygon = [&complex](std::span<const VertexId> ring) {
    CGAL::Polygon_2<Kernel> result;
    for (const VertexId v : ring) result.push_back(to_cgal(complex.vertices[v]));
    return result;
  };
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> all;
  for (const FacePolygon& face : plumbline::polygons(complex)) {
    all.emplace_back(polygon(face.outer));
    for (std::size_t h = 0; h < face.holes.size(); ++h) all.back().add_hole(polygon(face.holes[h]));
  }
  return all;
}

}  // namespace cgal

ExactComplex cgal_engine(const SegmentSet& input) {
  return cgal::to_complex(cgal::arrangement(input), input);
}

}  // namespace plumbline
