// Cases whose rounding is known by hand.

#include <catch2/catch.hpp>

#include <rapidjson/document.h>

#include <algorithm>
#include <set>

#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"
#include "plumbline/round.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// The edges of a complex, one after the other: "0 0, 1 1; ...".
std::string edges(const ExactComplex& c) {
  std::string text;
  for (const auto& [tail, head] : c.edges) {
    text += (text.empty() ? "" : "; ") + to_text(Segment{c.vertices[tail], c.vertices[head]});
  }
  return text;
}

std::string vertices(const ExactComplex& c) {
  std::string text;
  for (const Point& p : c.vertices) text += (text.empty() ? "" : ", ") + to_text(p);
  return text;
}

/// Rounds the arrangement; checks that the rounding is verified and rounded to itself.
struct Rounded {
  Rounded(const std::string& text, const Grid& grid)
      : exact_complex(arrange(segments(text))),
        rounding(safely_rounded(exact_complex, grid)),
        change(changes(exact_complex, rounding)) {
    ensure_rounded(exact_complex, grid, rounding);
    const Rounding again = safely_rounded(rounding.complex, grid);
    CHECK(again.has_same_incidences());
    CHECK(again.complex == rounding.complex);
    CHECK(changes(rounding.complex, again).moved_vertices.empty());
    CHECK(is_kept_by_simple_rounding(rounding.complex, grid));
    CHECK(rounding.valid_as_doubles == is_kept_by_simple_rounding(rounding.complex, {}));
  }

  ExactComplex exact_complex;
  Rounding rounding;
  RoundingChanges change;
};

constexpr std::optional<int> kDoubles;

}  // namespace

TEST_CASE("coordinates on the grid stay as they are") {
  const Rounded r(rectangle(0, 0, 4, 4) + "0 0 1.25 1.5", {2});
  CHECK(r.rounding.method == RoundingMethod::NearestPoints);
  CHECK(r.rounding.complex == r.exact_complex);
  CHECK(r.change.moved_vertices.empty());
  CHECK(r.change.largest_squared_movement() == 0);
}

TEST_CASE("an empty complex and a lone point are rounded") {
  CHECK(Rounded("", {kDoubles}).rounding.complex == arrange(segments("")));
  CHECK(Rounded("", {0}).rounding.complex == arrange(segments("")));
  CHECK(vertices(Rounded("+ 1/3 -1/3", {1}).rounding.complex) == "0.3 -0.3");
}

TEST_CASE("ties go upwards on decimals, to even on doubles") {
  CHECK(vertices(Rounded("+ 0.5 1.5  + -0.5 2.5  + -1.5 -2.5", {0}).rounding.complex) ==
        "-1 -2, 0 3, 1 2");
  // 2^53 + 1 lies between two doubles, 2^53 + 3 as well.
  CHECK(vertices(Rounded("+ 9007199254740993 9007199254740995", {kDoubles}).rounding.complex) ==
        "9007199254740992 9007199254740996");
}

TEST_CASE("thirds go to the nearest doubles, with the same incidences") {
  const Rounded r("0 0 1 1  0 1/3 1 1/3  0 2/3 1 2/3", {kDoubles});
  CHECK(r.rounding.method == RoundingMethod::NearestDoubles);
  CHECK(r.rounding.complex == exact(nearest(r.exact_complex)));
  CHECK(r.rounding.spacing == Rational(1, mpz_class(1) << 52));
  CHECK(r.change.moved_vertices.size() == 6);
  CHECK(r.change.largest_squared_movement() ==
        squared_distance(Point{rational_from(2.0 / 3), rational_from(2.0 / 3)},
                         Point{Rational(2, 3), Rational(2, 3)}));
}

TEST_CASE("vertices whose x tie when rounded change their order, not their incidences") {
  const Rounded r("0.31 5 9 9  0.32 1 9 9", {1});
  CHECK(r.rounding.has_same_incidences());
  CHECK(edges(r.rounding.complex) == "0.3 1, 9 9; 0.3 5, 9 9");
  CHECK(r.rounding.vertex_image == std::vector{VertexId(1), VertexId(0), VertexId(2)});
  CHECK(r.rounding.edge_image[0][0] == halfedge(EdgeId(1), false));
}

TEST_CASE("two vertices in one pixel merge") {
  const Rounded r("0 0 4.1 0  4.2 0.1 8 8", {0});
  CHECK(r.rounding.method == RoundingMethod::SnapRounded);
  CHECK(edges(r.rounding.complex) == "0 0, 4 0; 4 0, 8 8");
  REQUIRE(r.change.merged_vertices.size() == 1);
  CHECK(r.change.merged_vertices[0].from == std::vector{VertexId(1), VertexId(2)});
  CHECK(r.rounding.complex.vertices[r.change.merged_vertices[0].into] == Point{4, 0});
  CHECK(r.change.largest_squared_movement() == Rational(1, 20));
}

TEST_CASE("an edge bends at a hot pixel where it would cross the vertex, and only there") {
  // Vertices on either side of the edge go to opposite sides of it.
  CHECK(Rounded("0 0 10 1  5 0.51 5 9  5 0.49 5 -9", {0}).rounding.has_same_incidences());
  // This one is above the edge, and rounded it would be below.
  const Rounded r("0 0 10 0.9  5 0.49 5 9", {0});
  CHECK(edges(r.rounding.complex) == "0 0, 5 0; 5 0, 5 9; 5 0, 10 1");
  CHECK(r.change.bent_edges.size() == 1);
  CHECK(r.change.merged_vertices.empty());
}

TEST_CASE("a vertex on an edge after rounding becomes one of its vertices") {
  const Rounded r("0 0 10 0.4  5 0.3 5 9", {0});
  CHECK(edges(r.rounding.complex) == "0 0, 5 0; 5 0, 5 9; 5 0, 10 0");
  REQUIRE(r.change.bent_edges.size() == 1);
  CHECK(r.change.bent_edges[0].edge == EdgeId(0));
  CHECK(r.change.bent_edges[0].squared_distance ==
        squared_distance({5, 0}, {0, 0}, {10, Rational(4, 10)}));
  CHECK(r.change.vanished_edges.empty());
}

TEST_CASE("a sliver that would flip is closed") {
  // Its apex is left of the hypotenuse, its rounded apex is right of it.
  const Rounded r("0 0 10 7  10 7 4.6 3.4  4.6 3.4 0 0", {0});
  CHECK(orientation({0, 0}, {10, 7}, {Rational(46, 10), Rational(34, 10)}) > 0);
  CHECK(orientation({0, 0}, {10, 7}, {5, 3}) < 0);
  CHECK(edges(r.rounding.complex) == "0 0, 5 3; 5 3, 10 7");
  CHECK(r.change.vanished_faces == std::vector{FaceId(1)});
  CHECK(r.change.merged_edges.size() == 2);
  CHECK(r.change.bent_edges.size() == 1);
}

TEST_CASE("edges that run beside each other and would cross are led through common vertices") {
  const ExactComplex c = arrange(segments("0 0 9 3.4  0 0.6 9 3.6"));
  const Grid whole{0};
  CHECK(c.edge_count() == 2);
  CHECK(is_kept_by_simple_rounding(c, whole));
  const Rounded r("0 0.4 9 3.4  0.6 0.4 9.2 3.6  3 1.5 6 2.4", {0});
  CHECK(to_text(validate(r.rounding.complex)) == "");
  CHECK_FALSE(r.rounding.has_same_incidences());
}

TEST_CASE("a loose piece is not carried past a line that has one face on both sides") {
  // The piece is below the line; its ends, rounded alone, would be above it.
  const Rounded r("0 0 10 3  3.4 1.01 6.4 1.91", {0});
  CHECK(edges(r.rounding.complex) == "0 0, 3 1; 3 1, 6 2; 6 2, 10 3");
  CHECK_FALSE(is_kept_by_simple_rounding(r.exact_complex, {0}));
  // So would a loose point, and one end of an antenna of the same component.
  CHECK(edges(Rounded("0 0 10 3  + 3.4 1.01", {0}).rounding.complex) == "0 0, 3 1; 3 1, 10 3");
  CHECK(edges(Rounded("0 0 10 3  3 -5 3.4 1.01", {0}).rounding.complex) ==
        "0 0, 3 1; 3 -5, 3 1; 3 1, 10 3");
  // Above the line they stay above it.
  CHECK(Rounded("0 0 10 3  3.4 1.1 6.4 2", {0}).rounding.has_same_incidences());
  CHECK(Rounded("0 0 10 3  + 3.4 1.1", {0}).rounding.has_same_incidences());
}

TEST_CASE("an edge within a pixel vanishes, and a component becomes an isolated vertex") {
  const Rounded r(rectangle(0, 0, 9, 9) + "4 4 4.2 4.1  4.2 4.1 4.1 4.3  4.1 4.3 4 4", {0});
  CHECK(summary(r.rounding.complex) == "V 5 E 4 F 2 C 2 isolated 1");
  CHECK(r.change.vanished_edges.size() == 3);
  CHECK(r.change.vanished_faces.size() == 1);
  CHECK(r.change.merged_vertices.size() == 1);
  CHECK(r.rounding.face_origin.size() == 2);
}

TEST_CASE("a hole that fills its face takes the place of both") {
  // The inner square is rounded onto the outer one: what was between them is gone.
  const Rounded r(rectangle(0, 0, 9, 9) + "0.2 0.2 8.8 0.2  8.8 0.2 8.8 8.8  8.8 8.8 0.2 8.8  " +
                      "0.2 8.8 0.2 0.2",
                  {0});
  CHECK(summary(r.rounding.complex) == "V 4 E 4 F 2 C 1");
  REQUIRE(r.change.vanished_faces.size() == 1);
  CHECK(r.exact_complex.face_holes[r.change.vanished_faces[0]].size() == 1);
  CHECK(r.change.merged_edges.size() == 4);
}

TEST_CASE("a face whose waist closes falls into two parts") {
  // An hourglass, 0.4 wide where it is narrowest.
  const Rounded r("0 0 4.8 5  4.8 5 0 10  0 10 10 10  10 10 5.2 5  5.2 5 10 0  10 0 0 0", {0});
  CHECK(summary(r.rounding.complex) == "V 5 E 6 F 3 C 1");
  REQUIRE(r.change.split_faces.size() == 1);
  CHECK(r.change.split_faces[0].into.size() == 2);
  CHECK(r.change.vanished_faces.empty());
}

TEST_CASE("a spiral whose end meets its wall closes a part of the outside") {
  const Rounded r("0 0 8 0  8 0 8 8  8 8 0 8  0 8 0 0.4", {0});
  CHECK(summary(r.rounding.complex) == "V 4 E 4 F 2 C 1");
  REQUIRE(r.change.split_faces.size() == 1);
  CHECK(r.change.split_faces[0].face == kUnbounded);
}

TEST_CASE("pixels are half-open: the upper sides belong to the neighbours") {
  // The edge runs along the upper side of the pixel of (2, 0); below it runs through it.
  const std::string hot = "2 0 2 -9  1.6 -0.3 1.6 -9  ";  // two vertices in one pixel: no short cut
  CHECK(edges(Rounded(hot + "0 0.5 4 0.5", {0}).rounding.complex).find("0 1, 4 1") !=
        std::string::npos);
  CHECK(edges(Rounded(hot + "0 -0.5 4 -0.5", {0}).rounding.complex).find("0 0, 2 0") !=
        std::string::npos);
  // Through the upper left corner it passes, through the lower left one it touches the pixel.
  CHECK(edges(Rounded(hot + "1 0 2 1", {0}).rounding.complex).find("1 0, 2 1") !=
        std::string::npos);
  CHECK(edges(Rounded(hot + "1 0.25 2 -1.25  9 9 8 8", {0}).rounding.complex).find("1 0, 2 0") !=
        std::string::npos);
}

TEST_CASE("doubles that would make an invalid complex give way to a uniform grid of doubles") {
  // The vertex is above the edge, the double nearest to it is below.
  const Rounded r("0 0 3 1  1 0.33333333333333333333333333334 1 5", {kDoubles});
  CHECK(r.rounding.method == RoundingMethod::SnapRounded);
  CHECK(r.rounding.spacing == Rational(1, mpz_class(1) << 50));
  CHECK(summary(r.rounding.complex) == "V 4 E 3 F 1 C 1 antennas 3");
  CHECK(r.change.bent_edges.size() == 1);
  for (const Point& p : r.rounding.complex.vertices) CHECK(exact(nearest(p)) == p);
}

TEST_CASE("coordinates from 1e-300 to 8e99 are rounded, with any number of decimals") {
  const std::string huge = "8" + std::string(99, '0');
  const std::string text = "1e-300 1e-300 " + huge + " 1/3  -1/7 2e-300 5 -" + huge + "  0 0 1 1";
  for (int decimals = 0; decimals <= 15; ++decimals) {
    CAPTURE(decimals);
    const Rounded r(text, {decimals});
    CHECK(to_text(validate(r.rounding.complex)) == "");
  }
  const Rounded r(text, {kDoubles});
  CHECK(to_text(validate(r.rounding.complex)) == "");
}

TEST_CASE("numbers of decimals beyond the range are refused") {
  const ExactComplex c = arrange(segments("0 0 1 1"));
  CHECK_THROWS_WITH(safely_rounded(c, {-1}), Catch::Contains("0 to 18") && Catch::Contains("-1"));
  CHECK_THROWS_WITH(safely_rounded(c, {19}), Catch::Contains("0 to 18"));
  CHECK(to_text(Grid{1}) == "1 decimal");
  CHECK(to_text(Grid{}) == "nearest doubles");
}

TEST_CASE("a verification refuses a rounding that breaks a guarantee") {
  const ExactComplex c = arrange(segments("0 0 10 0.4  5 0.3 5 9  7 3 9 3"));
  const Grid grid{0};
  const Rounding right = safely_rounded(c, grid);
  const auto refused = [&](auto change, const std::string& reason) {
    Rounding wrong = right;
    change(wrong);
    CHECK_THROWS_WITH(ensure_rounded(c, grid, wrong), Catch::Contains(reason));
  };
  const auto is_at = [&](std::size_t v, const Point& p) {
    return [v, p](Rounding& r) { r.complex.vertices.replace(v, p); };
  };
  const PointList& places = right.complex.vertices;
  const std::size_t last = places.size() - 1;
  ensure_rounded(c, grid, right);
  refused(is_at(0, {places[0].x, Rational(1, 10)}), "not on the grid");
  refused(is_at(last, {places[last].x, 1}), "moved too far");
  refused(is_at(0, {6, places[0].y}), "");
  refused([](Rounding& r) { std::swap(r.vertex_image[0], r.vertex_image[1]); }, "moved too far");
  refused([](Rounding& r) { r.edge_image = {}; }, "edges are missing");
  refused([](Rounding& r) { std::swap(r.spacing, r.spacing = Rational(1, 100)); }, "too far");
  refused([](Rounding& r) { r.face_origin[0] = FaceId(); }, "another face");
  refused(
      [](Rounding& r) {
        Lists<HalfedgeId> images;
        for (std::size_t e = 0; e < r.edge_image.size(); ++e) {
          images.push_back(r.edge_image[e == 0 ? 1 : e]);
        }
        r.edge_image = images;
      },
      "gap");
  // What simple rounding would do here.
  const Rounding past = safely_rounded(arrange(segments("0 0 10 3  3 1 6 2")), grid);
  CHECK_THROWS_WITH(ensure_rounded(arrange(segments("0 0 10 3  3.4 1.01 6.4 1.91")), grid, past),
                    Catch::Contains("went past an edge"));
}

TEST_CASE("rounded edges written as .lines are the complex, digit for digit") {
  const Rounded r("0 0 1 1  0 1/3 1 1/3  1/7 -1 1/7 2", {kDoubles});
  std::string text = to_lines(r.rounding.complex);
  CHECK(text.substr(0, text.find('\n')).find('/') == std::string::npos);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::replace(text.begin(), text.end(), '\n', ' ');
  const ExactComplex again = arrange(segments(text));
  CHECK(again.vertices == r.rounding.complex.vertices);
  CHECK(again.edges == r.rounding.complex.edges);
  CHECK(again.cycles == r.rounding.complex.cycles);
}

TEST_CASE("the numbers of the JSON file are those of the rounded complex") {
  for (const char* text :
       {"0 0 1 1  0 1/3 1 1/3  1/7 -1 1/7 2", "0 0 10 0.4  5 0.3 5 9  7 3 9 3"}) {
    for (const Grid& grid : {Grid{kDoubles}, Grid{2}, Grid{0}}) {
      CAPTURE(text, to_text(grid));
      const SegmentSet input = segments(text);
      const ExactComplex c = arrange(input);
      const Rounding r = safely_rounded(c, grid);
      rapidjson::Document json;
      json.Parse<rapidjson::kParseFullPrecisionFlag>(to_json(c, input, grid, r).c_str());
      REQUIRE(!json.HasParseError());
      CHECK(json["rounding"]["same_incidences"].GetBool() == r.has_same_incidences());
      CHECK(json["exact"].GetBool() == r.has_same_incidences());
      const auto nearest_of = [&](const rapidjson::Value& v) {
        const auto& p = json["vertices"][v.GetUint()]["nearest"];
        return PointD{p[0].GetDouble(), p[1].GetDouble()};
      };
      std::set<std::pair<PointD, PointD>> written, expected;
      for (const auto& e : json["edges"].GetArray()) {
        written.insert(std::minmax(nearest_of(e["tail"]), nearest_of(e["head"])));
      }
      for (const auto& [tail, head] : r.complex.edges) {
        expected.insert({nearest(r.complex.vertices[tail]), nearest(r.complex.vertices[head])});
      }
      CHECK(written == expected);
      CHECK(json["faces"].Size() == r.complex.face_count());
      if (r.has_same_incidences()) continue;
      const RoundingChanges change = changes(c, r);
      CHECK(json["rounding"]["moved_vertices"].Size() == change.moved_vertices.size());
      CHECK(json["rounding"]["bent_edges"].Size() == change.bent_edges.size());
    }
  }
}
