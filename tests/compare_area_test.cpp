// Exact areas: what faces that differ do not have in common, where faces overlap or leave gaps.

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "compare/overlay.hpp"
#include "compare/winding.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/compare.hpp"
#include "plumbline/engine/cell_lists.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// The findings about faces, one a line: disagreement, faces, area.
std::string areas(const Comparison& result) {
  std::string text;
  const auto list = [&](const char* side, const std::vector<std::size_t>& cells) {
    if (!cells.empty()) text += std::string(" ") + side;
    for (const std::size_t cell : cells) text += ' ' + std::to_string(cell);
  };
  for (const Finding& f : result.findings) {
    if (!f.area) continue;
    text += to_text(f.kind) + ' ' + to_text(f.disagreement);
    list("exact", f.exact_cells);
    list("float", f.float_cells);
    text += " area " + exact_text(*f.area) + '\n';
  }
  return text;
}

std::string areas(const std::string& exact_drawing, const std::string& float_drawing,
                  double tolerance) {
  return areas(compare(arrange(segments(exact_drawing)), nearest(arrange(segments(float_drawing))),
                       tolerance));
}

CellLists squares(std::initializer_list<std::array<double, 3>> corners_and_sides) {
  CellLists cells;
  for (const auto& [x, y, side] : corners_and_sides) {
    const std::size_t first = cells.vertices.size();
    for (const PointD p : {PointD{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}) {
      cells.vertices.push_back(p);
    }
    cells.faces.push_back(
        {{VertexId(first), VertexId(first + 1), VertexId(first + 2), VertexId(first + 3)}});
  }
  return cells;
}

/// So many segments between places of a small grid, many of which overlap.
std::string on_grid(std::mt19937& random, std::size_t count, unsigned side) {
  std::string text;
  for (std::size_t i = 0; i < 4 * count; ++i) text += std::to_string(random() % side) + ' ';
  return text;
}

/// The area of each pair of faces (0: none), of some of the faces of each side.
std::map<std::pair<std::size_t, std::size_t>, Rational> overlaps(
    const compare_steps::Sides& sides, const compare_steps::Both<std::vector<std::size_t>>& faces,
    bool are_valid) {
  std::map<std::pair<std::size_t, std::size_t>, Rational> result;
  const auto regions = compare_steps::overlay(sides, faces, are_valid);
  REQUIRE(regions);
  for (const compare_steps::Region& region : *regions) {
    const auto face = [&](compare_steps::Side side) {
      return region.faces[side].empty() ? 0 : region.faces[side].front();
    };
    result[{face(compare_steps::Exact), face(compare_steps::Float)}] += region.area;
  }
  return result;
}

/// What is wrong with the areas that the polygons cover.
std::string coverage(const CellLists& cells, double tolerance = 0) {
  const FloatComplex complex = complex_from_faces(cells);
  const Comparison result = compare(arrange(segments("")), complex, tolerance);
  std::string text;
  for (const Finding& f : result.findings) {
    if (f.invariant == Invariant::Area) text += f.message + '\n';
  }
  return text;
}

const std::string kRoom = rectangle(0, 0, 9, 9);

}  // namespace

TEST_CASE("faces that cover the same differ by no area, whatever their edges") {
  CHECK(areas(rectangle(0, 0, 4, 2) + "2 0 2 2",
              "0 0 2 0  2 0 4 0  4 0 4 2  4 2 2 2  2 2 0 2  0 2 0 0",
              0.1) == "face merged exact 1 2 float 1 area 0\n");
  CHECK(areas(rectangle(0, 0, 4, 2), "0 0 2 0  2 0 4 0  4 0 4 2  4 2 0 2  0 2 0 0", 0.1) ==
        "face reshaped exact 1 float 1 area 0\n");
}

TEST_CASE("a face with another roof differs by the area between the roofs") {
  CHECK(areas(rectangle(0, 0, 4, 4), "0 0 4 0  4 0 4 4  4 4 2 5  2 5 0 4  0 4 0 0", 0.1) ==
        "face reshaped exact 1 float 1 area 2\n");
  // 1/3 of a unit higher, over a third of the width each side.
  CHECK(areas(rectangle(0, 0, 4, 4), "0 0 4 0  4 0 4 4  4 4 4/3 13/3  4/3 13/3 0 4  0 4 0 0", 0.1)
            .starts_with("face reshaped exact 1 float 1 area "));
}

TEST_CASE("a missing face differs by all of its area, without its holes") {
  CHECK(areas(kRoom + rectangle(2, 2, 4, 4), kRoom, 0.1) == "face missing exact 2 area 4\n");
  CHECK(areas(kRoom + rectangle(2, 2, 4, 4), rectangle(2, 2, 4, 4), 0.1) ==
        "face missing exact 1 area 77\n");
}

TEST_CASE("faces without common boundaries correspond by what they cover most") {
  // The same room, its walls drawn in other pieces and a little elsewhere.
  CHECK(areas(rectangle(0, 0, 4, 4) + rectangle(10, 0, 14, 4),
              "0 1 1 0  1 0 5 0  5 0 5 5  5 5 0 5  0 5 0 1  20 20 21 20  21 20 20 21  20 21 20 20",
              0.01) ==
        "face reshaped exact 1 float 1 area 9.5\nface missing exact 2 area 16\n"
        "face extra float 2 area 0.5\n");
}

TEST_CASE("polygons that overlap are found with the area that they share") {
  CHECK(coverage(squares({{0, 0, 4}, {3, 1, 2}})) ==
        "the float result is not a valid complex: float face 1 and float face 2 overlap in an area "
        "of 2 (area), because of findings 1 and 2\n");
  CHECK(coverage(squares({{0, 0, 4}, {4, 0, 4}, {0, 4, 4}})) == "");
}

TEST_CASE("a face that is left out leaves a gap of its area, if others remain around it") {
  const ExactComplex plan = arrange(segments(kRoom + rectangle(2, 2, 4, 5)));
  FloatComplex lacking = nearest(plan);
  REQUIRE(plan.face_count() == 3);
  lacking.face_outer.pop_back();
  Lists<CycleId> holes;
  Lists<VertexId> isolated;
  for (std::size_t f = 0; f < 2; ++f) {
    holes.push_back(plan.face_holes[f]);
    isolated.push_back(std::vector<VertexId>());
  }
  lacking.face_holes = holes;
  lacking.face_isolated_vertices = isolated;
  const Comparison result = compare(plan, canonical(lacking), 0);
  const auto gap = std::find_if(result.findings.begin(), result.findings.end(),
                                [](const Finding& f) { return f.invariant == Invariant::Area; });
  REQUIRE(gap != result.findings.end());
  CHECK(gap->area == Rational(6));
  CHECK(gap->float_cells.empty());
  CHECK(locate(plan, gap->where) == FaceId(2));
  CHECK(gap->message.find("no face covers a gap of area 6") != std::string::npos);
}

TEST_CASE("a polygon that is listed twice overlaps with itself") {
  const CellLists cells = squares({{0, 0, 4}, {0, 0, 4}});
  CHECK(coverage(cells).find("overlap in an area of 16") != std::string::npos);
}

TEST_CASE("an overlap no wider than the tolerance follows from the edges that cross") {
  const CellLists cells = squares({{0, 0, 4}, {3.875, 1, 2}});
  CHECK(coverage(cells, 0.01).find("overlap in an area of 0.25") != std::string::npos);
  CHECK(coverage(cells, 0.25) == "");
}

TEST_CASE("windings count how often boundaries run around a place") {
  // A square run twice, another one once the other way round inside.
  std::vector<compare_steps::BoundaryPiece> pieces;
  const auto add = [&](const std::vector<Point>& corners, std::size_t label) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      pieces.push_back({corners[i], corners[(i + 1) % corners.size()], label, EdgeId()});
    }
  };
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  add(square, 7);
  add(square, 7);
  add({{1, 1}, {1, 2}, {2, 2}, {2, 1}}, 5);
  add({{6, 0}, {6, 0}, {6, 0}}, 9);  // no boundary at all
  const auto result = compare_steps::overlaid(pieces, {{3, 1}});
  REQUIRE(result);
  const auto at = [&](const Point& p) { return result->windings[locate(result->complex, p)]; };
  using Windings = compare_steps::Windings;
  CHECK(at({9, 9}) == Windings{{3, 1}});
  CHECK(at({3, 3}) == Windings{{3, 1}, {7, 2}});
  CHECK(at({Rational(3, 2), Rational(3, 2)}) == Windings{{3, 1}, {5, -1}, {7, 2}});
  CHECK_FALSE(compare_steps::overlaid({{{0, 0}, {rational_from(1e300), 0}, 0, EdgeId()}}, {}));
}

TEST_CASE("the areas that valid complexes have in common are those of their arrangement") {
  std::mt19937 random(1);
  std::size_t pairs = 0;
  for (std::size_t round = 0; round < 300; ++round) {
    const auto size = static_cast<unsigned>(3 + round % 6);
    const std::string drawing = on_grid(random, 4 + round % 17, size);
    // Drawings that have nothing in common, or most, or all but an inner part.
    std::string other = on_grid(random, 3 + round % 9, size);
    if (round % 3 == 1) other += drawing;
    if (round % 3 == 2) other = drawing + "1/3 1/3 1/2 1/3 1/2 1/3 1/2 5/8 1/2 5/8 1/3 1/3";
    const ExactComplex a = arrange(segments(drawing)), b = arrange(segments(other));
    const compare_steps::Sides sides = compare_steps::make_sides(a, b, 0);
    compare_steps::Both<std::vector<std::size_t>> faces;
    for (const compare_steps::Side side : compare_steps::kBothSides) {
      for (std::size_t f = 1; f < sides[side].face_count(); ++f) {
        if (round % 2 == 0 || random() % 3 != 0) faces[side].push_back(f);
      }
    }
    CAPTURE(drawing, other);
    const auto summed = overlaps(sides, faces, true);
    REQUIRE(summed == overlaps(sides, faces, false));
    pairs += summed.size();
  }
  CHECK(pairs > 3000);
}
