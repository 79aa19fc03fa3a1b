// CGAL with inexact constructions, which its manual advises against for arrangements and many use
// for speed; and with exact ones, as it advises, whose coordinates are rounded at the end.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include <cmath>
#include <limits>

#include "adapter.hpp"
#include "loops.hpp"

namespace {

using study::Clock;
using study::Edge;
using study::Model;
using study::Numbering;
using study::Ring;

using Double = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

double rounded(double value) { return value; }
// The nearest double: to_double of a lazy number may be far off, and of an exact one truncates.
double rounded(const Epeck::FT& value) {
  const Epeck::FT::ET& exact = value.exact();
  double nearest = CGAL::to_double(exact);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double other : {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)})
    if (CGAL::abs(exact - other) < CGAL::abs(exact - nearest)) nearest = other;
  return nearest;
}

template <class Point>
study::Point rounded_point(const Point& p) {
  return {rounded(p.x()), rounded(p.y())};
}

template <class Arrangement>
Model model_of(const Arrangement& arrangement) {
  Numbering number;
  const auto numbered = [&](const auto& vertex) { return number(rounded_point(vertex->point())); };
  std::vector<Edge> edges;
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    edges.push_back({numbered(e->source()), numbered(e->target())});
  }
  Model model;
  model.edges = study::each_once(std::move(edges));
  model.vertices = std::move(number).points();
  const auto rings = [&](auto start) {
    Ring walk;
    auto at = start;
    do {
      walk.push_back(numbered(at->source()));
      ++at;
    } while (at != start);
    return study::rings_of_walk(walk, model.vertices);
  };
  model.polygons.emplace();
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->is_unbounded()) continue;
    std::vector<Ring> polygon = rings(face->outer_ccb());
    for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
      for (Ring& ring : rings(*hole)) polygon.push_back(std::move(ring));
    }
    model.polygons->push_back(std::move(polygon));
  }
  return model;
}

template <class Kernel>
Model arranged(const std::vector<study::Segment>& segments, Clock& clock, double) {
  using Traits = CGAL::Arr_segment_traits_2<Kernel>;
  std::vector<typename Traits::Curve_2> curves;
  for (const study::Segment& s : segments) {
    curves.emplace_back(typename Traits::Point_2(s[0][0], s[0][1]),
                        typename Traits::Point_2(s[1][0], s[1][1]));
  }
  clock.start();
  CGAL::Arrangement_2<Traits> arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  clock.stop();
  return model_of(arrangement);
}

template <class Kernel, class Tag>
Model triangulated(const std::vector<study::Segment>& segments, Clock& clock, double) {
  using Points = CGAL::Triangulation_vertex_base_2<Kernel>;
  using Triangles = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Points, Triangles>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, Tag>;
  clock.start();
  CGAL::Constrained_triangulation_plus_2<Delaunay> t;
  for (const study::Segment& s : segments) {
    using Point = typename Kernel::Point_2;
    t.insert_constraint(Point(s[0][0], s[0][1]), Point(s[1][0], s[1][1]));
  }
  clock.stop();
  Numbering number;
  const auto numbered = [&](const auto& p) { return number(rounded_point(p)); };
  std::vector<Edge> edges;
  for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    if (!t.is_constrained(*e)) continue;
    const auto s = t.segment(*e);
    edges.push_back({numbered(s.source()), numbered(s.target())});
  }
  Model model;
  model.edges = study::each_once(std::move(edges));
  model.vertices = std::move(number).points();
  return model;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<study::Configuration> configurations = {
      {"arrangement-double", "Arrangement_2, Simple_cartesian<double>", "none", 0,
       "Arr_segment_traits_2: an inexact kernel 'usually leads to shorter running times', and "
       "'causes robustness problems in most cases'",
       arranged<Double>},
      {"arrangement-epick", "Arrangement_2, EPICK", "none", 0,
       "2D Arrangements: exact predicates alone are not enough, so against the manual's advice",
       arranged<Epick>},
      {"triangulation-epick", "Constrained_triangulation_plus_2, EPICK", "none", 0,
       "2D Triangulations: Exact_predicates_tag, with crossings that are rounded",
       triangulated<Epick, CGAL::Exact_predicates_tag>},
  };
#ifdef NDEBUG
  const std::string engine = "cgal";
  const std::string title = "CGAL";
  configurations.push_back({"arrangement-epeck", "Arrangement_2, EPECK, rounded at the end", "none",
                            0, "2D Arrangements: exact constructions, which the manual advises",
                            arranged<Epeck>});
  configurations.push_back(
      {"triangulation-epeck", "Constrained_triangulation_plus_2, EPECK, rounded at the end", "none",
       0, "2D Triangulations: Exact_intersections_tag, for kernels with exact constructions",
       triangulated<Epeck, CGAL::Exact_intersections_tag>});
#else
  const std::string engine = "cgal_checked";
  const std::string title = "CGAL, with assertions";
#endif
  return study::serve(
      {engine, title, CGAL_VERSION_STR, "CGAL", "GPL-3.0-or-later", std::move(configurations)},
      argc, argv);
}
