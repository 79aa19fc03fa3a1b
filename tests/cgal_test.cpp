#include "plumbline/cgal.hpp"

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
