// Curves meet what meets them in the drawing.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "inputs/curve_scenes.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"

using plumbline::arrange;
using plumbline::dxf_with;
using plumbline::evaluate;
using plumbline::ExactComplex;
using plumbline::Point;
using plumbline::Rational;
using plumbline::SegmentSet;
using plumbline::Structure;

namespace {

// Entities, each with a blank before it.
std::string line(const std::string& ax, const std::string& ay, const std::string& bx,
                 const std::string& by) {
  return " 0 LINE 8 0 10 " + ax + " 20 " + ay + " 11 " + bx + " 21 " + by;
}
std::string circle(const std::string& x, const std::string& y, const std::string& r) {
  return " 0 CIRCLE 8 0 10 " + x + " 20 " + y + " 40 " + r;
}
std::string arc(const std::string& x, const std::string& y, const std::string& r,
                const std::string& from, const std::string& to) {
  return " 0 ARC 8 0 10 " + x + " 20 " + y + " 40 " + r + " 50 " + from + " 51 " + to;
}
/// About the origin, the other axis 0.4 times as long.
std::string ellipse(const std::string& x, const std::string& y) {
  return " 0 ELLIPSE 8 0 10 0 20 0 11 " + x + " 21 " + y + " 40 0.4";
}

SegmentSet segments(const std::string& entities, bool join_curves = true) {
  plumbline::ReadOptions options;
  options.join_curves = join_curves;
  return evaluate(read_dxf(dxf_with(entities.substr(1)), "a.dxf", options));
}
ExactComplex complex(const std::string& entities) { return arrange(segments(entities)); }

std::size_t antennas(const ExactComplex& c) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < c.edge_count(); ++e) count += c.is_antenna(plumbline::EdgeId(e));
  return count;
}
bool has_vertex(const ExactComplex& c, const Point& p) {
  return std::find(c.vertices.begin(), c.vertices.end(), p) != c.vertices.end();
}
bool has_vertex_near(const ExactComplex& c, double x, double y, double reach) {
  return std::any_of(c.vertices.begin(), c.vertices.end(), [&](const Point& p) {
    return std::hypot(p.x.get_d() - x, p.y.get_d() - y) <= reach;
  });
}
double bounded_area(const ExactComplex& c) {
  Rational area = 0;
  const auto areas = face_areas(c);
  for (std::size_t f = 1; f < areas.size(); ++f) area += areas[f];
  return area.get_d();
}

const std::string kPie = line("0", "0", "10", "0") + arc("0", "0", "10", "0", "30") +
                         line("8.660254037844387", "5", "0", "0");

}  // namespace

TEST_CASE("an arc of short numbers ends where the line with the rounded end does") {
  const ExactComplex pie = complex(kPie);
  CHECK(pie.face_count() == 2);
  CHECK(antennas(pie) == 0);
  CHECK(has_vertex(pie, {plumbline::parse_decimal("8.660254037844387"), 5}));
  CHECK(bounded_area(pie) == Approx(std::acos(-1.0) * 100 / 12).epsilon(1e-3));
}

TEST_CASE("arcs that are printed in doubles end where their lines do") {
  const ExactComplex sector = complex(
      arc("0", "0", "40", "30", "75") + arc("0", "0", "25", "30", "75") +
      line("21.65063509461097", "12.499999999999998", "34.64101615137755", "19.999999999999996") +
      line("6.4704761275630185", "24.148145657226706", "10.35276180410083", "38.63703305156273"));
  CHECK(sector.face_count() == 2);
  CHECK(antennas(sector) == 0);
  CHECK(bounded_area(sector) == Approx(382.8816).epsilon(1e-3));
}

TEST_CASE("an end of short numbers beyond the bound of an arc stays apart") {
  const ExactComplex pie = complex(line("0", "0", "10", "0") + arc("0", "0", "10", "0", "30") +
                                   line("8.66025403", "5", "0", "0"));
  CHECK(pie.face_count() == 1);
}

TEST_CASE("curves stay where the file's numbers have them where that is asked for") {
  CHECK(arrange(segments(kPie, false)).face_count() == 1);
  CHECK(segments(kPie, false).ledger.size() + 1 == segments(kPie).ledger.size());
}

TEST_CASE("what the ledger says of joined ends bounds how far they moved") {
  const SegmentSet apart = segments(kPie, false), joined = segments(kPie);
  const double moved =
      std::sqrt(squared_distance(apart.segments[10].b, joined.segments[10].b).get_d());
  CHECK(moved > 0);
  CHECK(joined.ledger.back().what == "1 ends of curves by what they meet");
  CHECK(moved <= std::stod(joined.ledger.back().bound));
  CHECK(moved <= 10 * 1e-15);
}

TEST_CASE("curves are joined alike for any order of the entities") {
  const ExactComplex pie = complex(kPie);
  CHECK(complex(line("8.660254037844387", "5", "0", "0") + arc("0", "0", "10", "0", "30") +
                line("0", "0", "10", "0"))
            .vertices == pie.vertices);
  CHECK(complex(arc("0", "0", "10", "0", "30") + line("0", "0", "8.660254037844387", "5") +
                line("10", "0", "0", "0"))
            .vertices == pie.vertices);
}

TEST_CASE("a curve whose end may be either of two, equally near, meets neither and is listed") {
  // The radius is known within 5e-14; the lines begin 4e-14 left and right of the arc's end.
  const SegmentSet set = segments(arc("0", "0", "10.0000000000012", "0", "90") +
                                  line("-0.00000000000004", "10.0000000000012", "-5", "20") +
                                  line("0.00000000000004", "10.0000000000012", "5", "20"));
  REQUIRE(set.remarks.size() == 1);
  CHECK(set.remarks.front().what.find("equally near") != std::string::npos);
}

TEST_CASE("lines that end on a circle end in a vertex of it") {
  const ExactComplex column =
      complex(line("-20", "-20", "20", "-20") + line("20", "-20", "20", "20") +
              line("20", "20", "-20", "20") + line("-20", "20", "-20", "-20") +
              circle("0", "0", "5") + line("3", "4", "15", "20") + line("-3", "4", "-15", "20") +
              line("-3", "-4", "-15", "-20") + line("3", "-4", "15", "-20"));
  CHECK(column.face_count() == 6);
  CHECK(antennas(column) == 0);
}

TEST_CASE("a tangent meets its circle in the point where it touches") {
  const ExactComplex level = complex(circle("0", "0", "5") + line("-10", "5", "10", "5"));
  CHECK(level.component_count() == 1);
  CHECK(level.face_count() == 2);
  const ExactComplex slanted = complex(circle("0", "0", "5") + line("11", "-2", "-5", "10"));
  CHECK(slanted.component_count() == 1);
  CHECK(slanted.face_count() == 2);
  CHECK(has_vertex(slanted, {3, 4}));
}

TEST_CASE("a line crosses a circle where it does, not where it crosses its chords") {
  const ExactComplex cut = complex(circle("0", "0", "5") + line("-10", "3", "10", "3.5"));
  CHECK(cut.face_count() == 3);
  // y = 3.25 + x / 40, x^2 + y^2 = 25
  const double a = 1 + 1.0 / 1600, b = 3.25 / 40, c = 3.25 * 3.25 - 25;
  for (const double sign : {-1.0, 1.0}) {
    const double x = (-b + sign * std::sqrt(b * b - a * c)) / a;
    CHECK(has_vertex_near(cut, x, 3.25 + x / 40, 1e-10));
  }
  // So near the top that the chords there are below it.
  CHECK(complex(circle("0", "0", "5") + line("-10", "4.9999", "10", "4.9999")).face_count() == 3);
}

TEST_CASE("circles cross and touch where they do") {
  const ExactComplex crossing = complex(circle("0", "0", "5") + circle("6", "0", "5"));
  CHECK(crossing.face_count() == 4);
  CHECK(has_vertex(crossing, {3, 4}));
  CHECK(has_vertex(crossing, {3, -4}));
  for (const auto& [x, y] : {std::pair("10", "0"), std::pair("6", "8"), std::pair("0", "2")}) {
    const ExactComplex touching =
        complex(circle("0", "0", "5") + circle(x, y, std::string(x) == "0" ? "3" : "5"));
    CHECK(touching.component_count() == 1);
    CHECK(touching.face_count() == 3);
  }
}

TEST_CASE("curves cross alike for any order and direction of what crosses them") {
  std::vector<std::string> entities{
      circle("0", "0", "5"),           circle("3", "1", "4"),           circle("3", "1", "4"),
      line("-10", "3", "10", "4"),     line("12", "4.1", "-4", "3.3"),  line("-10", "-7", "9", "8"),
      line("-1", "3.45", "9", "3.95"), arc("-3", "1", "6", "300", "60")};
  const auto all = [&] {
    std::string text;
    for (const std::string& entity : entities) text += entity;
    return complex(text);
  };
  const ExactComplex first = all();
  std::reverse(entities.begin(), entities.end());
  CHECK(all().vertices == first.vertices);
  std::rotate(entities.begin(), entities.begin() + 3, entities.end());
  CHECK(all().vertices == first.vertices);
  for (std::string& entity : entities) {
    if (entity == line("-10", "3", "10", "4")) entity = line("10", "4", "-10", "3");
  }
  CHECK(all().vertices == first.vertices);
}

TEST_CASE("what lies far away does not move where curves cross") {
  const std::string near = circle("0", "0", "5") + line("-10", "3", "10", "3") +
                           circle("6", "0", "5") + line("-10", "7", "10", "7");
  const std::size_t faces = complex(near).face_count();
  for (const int zeros : {6, 9, 12, 16, 30}) {
    const std::string far = "1" + std::string(static_cast<std::size_t>(zeros), '0');
    const ExactComplex both = complex(near + line(far, far, far, "2" + far.substr(1)));
    CAPTURE(zeros);
    CHECK(both.face_count() == faces);
    CHECK(has_vertex_near(both, 4, 3, 0.02));
    CHECK(has_vertex_near(both, 3, 4, 0.02));
  }
}

TEST_CASE("the same circle twice is one, and lines cross it once") {
  const ExactComplex once = complex(circle("0", "0", "5") + line("-10", "3", "10", "3"));
  const ExactComplex twice = complex(circle("0", "0", "5") + circle("0", "0", "5") +
                                     line("-10", "3", "10", "3") + line("10", "3", "-10", "3"));
  CHECK(twice.vertices == once.vertices);
  CHECK(twice.face_count() == once.face_count());
}

TEST_CASE("ellipses cross where they do") {
  // x^2 / 25 + y^2 / 4 = 1 and the same turned by a right angle: x^2 = y^2 = 100 / 29.
  const ExactComplex crossing = complex(ellipse("5", "0") + ellipse("0", "5"));
  CHECK(crossing.face_count() == 6);
  const double at = std::sqrt(100.0 / 29);
  for (const double x : {-at, at}) {
    for (const double y : {-at, at}) CHECK(has_vertex_near(crossing, x, y, 1e-10));
  }
}

TEST_CASE("scenes that are drawn in doubles have the faces that were drawn") {
  for (std::uint64_t number = 0; number < 500; ++number) {
    const plumbline::inputs::CurveScene scene = plumbline::inputs::curve_scene(number);
    INFO(number << ": " << scene.name);
    const bool is_svg = scene.file == "scene.svg";
    const ExactComplex drawn =
        arrange(evaluate(is_svg ? plumbline::read_svg(scene.text, scene.file)
                                : plumbline::read_dxf(scene.text, scene.file)));
    CHECK(drawn.face_count() == scene.faces);
    CHECK(antennas(drawn) == 0);
  }
}
