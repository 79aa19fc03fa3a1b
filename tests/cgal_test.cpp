#include "plumbline/cgal.hpp"

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Gps_segment_traits_2.h>

#include <catch2/catch.hpp>

#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

TEST_CASE("a user gets CGAL's own arrangement, with the sources of each edge") {
  const cgal::Arrangement arrangement = cgal::arrangement(segments("0 0 2 0  1 0 3 0  1 -1 1 1"));
  CHECK(arrangement.number_of_vertices() == 6);
  CHECK(arrangement.number_of_edges() == 5);
  CHECK(arrangement.is_valid());
  std::size_t sources = 0;
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    sources += e->curve().data().size();
  }
  CHECK(sources == 6);
}

TEST_CASE("CGAL's arrangement and the complex are the same subdivision") {
  const SegmentSet input =
      segments(rectangle(0, 0, 9, 9) + rectangle(1, 1, 2, 2) + "0 3 9 7  + 5 5");
  CHECK(cgal::to_complex(cgal::arrangement(input), input) == arrange(input));
}

TEST_CASE("points cross to CGAL and back unchanged") {
  const Point p{Rational(1, 3), parse_decimal("0.1")};
  CHECK(cgal::from_cgal(cgal::to_cgal(p)) == p);
}

TEST_CASE("doubles of another kernel are taken as they are") {
  const CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 p(0.1, -0.75);
  CHECK(cgal::from_cgal(p) == Point{rational_from(0.1), Rational(-3, 4)});
}

TEST_CASE("any arrangement of segments is arranged to the complex that it is") {
  const SegmentSet input =
      segments(rectangle(0, 0, 9, 9) + rectangle(1, 1, 2, 2) + "0 3 9 7  + 5 5");
  CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<cgal::Kernel>> own;
  for (const Segment& s : input.segments) CGAL::insert(own, cgal::to_cgal(s));
  for (const Point& p : input.points) CGAL::insert_point(own, cgal::to_cgal(p));
  CHECK(signature(arrange(cgal::segments(own))) == signature(arrange(input)));

  using Doubles = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Doubles>> of_doubles;
  CGAL::insert(of_doubles, Doubles::Segment_2({0.1, 0}, {2, 0.3}));
  SegmentSet one;
  one.add(PointD{0.1, 0}, PointD{2, 0.3}, one.add_source({}));
  CHECK(signature(arrange(cgal::segments(of_doubles))) == signature(arrange(one)));
}

TEST_CASE("faces are polygons that CGAL calls valid, of the same areas") {
  const auto drawing = GENERATE(
      as<std::string>(), "", "0 0 1 0", rectangle(0, 0, 9, 9) + rectangle(1, 1, 2, 2) + "0 3 9 7",
      // A hole that touches the boundary, a room that touches itself, antennas.
      "0 0 6 0  6 0 6 6  6 6 0 0  6 2 5 2  5 2 5.5 3  5.5 3 6 2  3 0 3 1  -4 0 0 0  0 0 -2 1/3  -2 "
      "1/3 -4 0",
      "0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0  1 2 2 1  2 1 3 2  3 2 2 3  2 3 1 2  2 1 2 0");
  const ExactComplex complex = arrange(segments(drawing));
  const auto faces = cgal::polygons(complex);
  REQUIRE(faces.size() + 1 == complex.face_count());
  const std::vector<Rational> areas = face_areas(complex);
  const CGAL::Gps_segment_traits_2<cgal::Kernel> traits;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    CHECK(CGAL::is_valid_polygon_with_holes(faces[f], traits));
    cgal::Kernel::FT area = faces[f].outer_boundary().area();
    for (const auto& hole : faces[f].holes()) area += hole.area();
    CHECK(CGAL::exact(area) == areas[f + 1]);
  }
}
