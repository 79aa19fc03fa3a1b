// CGAL with inexact constructions, which its manual advises against for arrangements and many use
// for speed.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

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

template <class Arrangement>
Model model_of(const Arrangement& arrangement) {
  Numbering number;
  const auto numbered = [&](const auto& vertex) {
    return number({vertex->point().x(), vertex->point().y()});
  };
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
Model arranged(const std::vector<study::Segment>& segments, Clock& clock) {
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

Model triangulated(const std::vector<study::Segment>& segments, Clock& clock) {
  using Points = CGAL::Triangulation_vertex_base_2<Epick>;
  using Triangles = CGAL::Constrained_triangulation_face_base_2<Epick>;
  using Structure = CGAL::Triangulation_data_structure_2<Points, Triangles>;
  using Delaunay =
      CGAL::Constrained_Delaunay_triangulation_2<Epick, Structure, CGAL::Exact_predicates_tag>;
  clock.start();
  CGAL::Constrained_triangulation_plus_2<Delaunay> t;
  for (const study::Segment& s : segments) {
    t.insert_constraint(Epick::Point_2(s[0][0], s[0][1]), Epick::Point_2(s[1][0], s[1][1]));
  }
  clock.stop();
  Numbering number;
  const auto numbered = [&](const Epick::Point_2& p) { return number({p.x(), p.y()}); };
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
  return study::serve(
#ifdef NDEBUG
      {
        "cgal", "CGAL, inexact constructions",
#else
      {"cgal_checked",
       "CGAL, inexact constructions, with assertions",
#endif
            CGAL_VERSION_STR, "CGAL", "GPL-3.0-or-later", {
          {"arrangement-double",
           "Arrangement_2, Simple_cartesian<double>",
           "none",
           0,
           "Arr_segment_traits_2: an inexact kernel 'usually leads to shorter running times', and "
           "'causes robustness problems in most cases'",
           arranged<Double>},
              {"arrangement-epick",
               "Arrangement_2, EPICK",
               "none",
               0,
               "2D Arrangements: exact predicates alone are not enough, so against the manual's "
               "advice",
               arranged<Epick>},
              {"triangulation-epick",
               "Constrained_triangulation_plus_2, EPICK",
               "none",
               0,
               "2D Triangulations: Exact_predicates_tag, with crossings that are rounded",
               triangulated},
        }
      },
      argc, argv);
}
