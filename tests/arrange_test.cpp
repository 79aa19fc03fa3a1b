#include "plumbline/arrange.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <utility>

#include "plumbline/error.hpp"
#include "support/affine_image.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Arranges with both engines, validates, returns the summary.
std::string arranged(const std::string& text) {
  const SegmentSet input = segments(text);
  const ExactComplex complex = arrange(input);
  CHECK(to_text(validate(complex)) == "");
  CHECK(to_text(validate_coverage(complex, input)) == "");
  CHECK(arrange(input, ExactEngine::Cgal) == complex);
  return summary(complex);
}

std::string sources(const ExactComplex& c) {
  std::string text;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    text += to_text(Segment{c.vertices[c.edges[e].tail], c.vertices[c.edges[e].head]}) + ":";
    for (const SegmentId s : c.edge_sources[e]) text += ' ' + std::to_string(s);
    text += '\n';
  }
  return text;
}

/// Random segments on a small lattice: full of overlaps, T-junctions and common points.
SegmentSet lattice_segments(unsigned seed, int count, int side) {
  std::mt19937 random(seed);
  const auto coordinate = [&] {
    return Rational(static_cast<int>(random() % static_cast<unsigned>(side)));
  };
  SegmentSet set;
  const SourceId source = set.add_source({});
  while (static_cast<int>(set.segments.size()) < count) {
    set.add({{coordinate(), coordinate()}, {coordinate(), coordinate()}}, source);
  }
  set.rejected.clear();
  return set;
}

SegmentSet mapped(const SegmentSet& input, const Affine& map) {
  SegmentSet result;
  const SourceId source = result.add_source({});
  for (const Segment& s : input.segments) result.add({apply(map, s.a), apply(map, s.b)}, source);
  return result;
}

}  // namespace

TEST_CASE("no segment leaves the unbounded face alone") {
  CHECK(arranged("") == "V 0 E 0 F 1 C 0");
}

TEST_CASE("one segment is one antenna of the unbounded face") {
  CHECK(arranged("0 0 3 1") == "V 2 E 1 F 1 C 1 antennas 1");
}

TEST_CASE("m vertical and n horizontal lines make (m-1)(n-1) bounded faces") {
  const auto [m, n] = GENERATE(std::pair{1, 1}, std::pair{2, 5}, std::pair{7, 3});
  std::string text;
  for (int i = 1; i <= m; ++i) {
    text += std::to_string(i) + " 0 " + std::to_string(i) + " " + std::to_string(n + 1) + "  ";
  }
  for (int j = 1; j <= n; ++j) {
    text += "0 " + std::to_string(j) + " " + std::to_string(m + 1) + " " + std::to_string(j) + "  ";
  }
  const SegmentSet input = segments(text);
  const ExactComplex c = arrange(input);
  CHECK(c.vertices.size() == static_cast<std::size_t>(m * n + 2 * (m + n)));
  CHECK(c.edge_count() == static_cast<std::size_t>(m * (n + 1) + n * (m + 1)));
  CHECK(c.face_count() == static_cast<std::size_t>((m - 1) * (n - 1) + 1));
  CHECK(to_text(validate(c)) == "");
  CHECK(to_text(validate_coverage(c, input)) == "");
}

TEST_CASE("k lines in general position make (k-1)(k-2)/2 bounded faces") {
  // Chords from (-100, i) to (100, i * i) for i = 1..k: slopes differ, no three meet (checked by
  // V).
  std::string text;
  const int k = 9;
  for (int i = 1; i <= k; ++i) {
    text += "-100 " + std::to_string(-50 * i) + " 100 " + std::to_string(i * i * i) + "  ";
  }
  CHECK(arranged(text) == "V 54 E 81 F 29 C 1 antennas 18");
}

TEST_CASE("nested squares nest, each the hole of the one around it") {
  CHECK(arranged(rectangle(0, 0, 9, 9) + rectangle(1, 1, 8, 8) + rectangle(2, 2, 7, 7) +
                 rectangle(3, 3, 6, 6)) == "V 16 E 16 F 5 C 4 holes 3 depth 4");
}

TEST_CASE("siblings in one square are two holes of it") {
  CHECK(arranged(rectangle(0, 0, 9, 9) + rectangle(1, 1, 4, 4) + rectangle(5, 5, 8, 8)) ==
        "V 12 E 12 F 4 C 3 holes 2 depth 2");
}

TEST_CASE("a star of segments through one point of thirds has one inner vertex") {
  CHECK(arranged("0 0 2/3 4/3   1/3 0 1/3 5   0 2/3 7 2/3   -1 2 5/3 -2/3   -2 -1/9 8/3 13/9") ==
        "V 11 E 10 F 1 C 1 antennas 10");
}

TEST_CASE("a collinear overlap becomes three edges, the middle one with both sources") {
  CHECK(sources(arrange(segments("0 0 2 0  3 0 1 0"))) ==
        "0 0, 1 0: 0\n1 0, 2 0: 0 1\n2 0, 3 0: 1\n");
}

TEST_CASE("equal and reversed segments are one edge with all sources") {
  CHECK(sources(arrange(segments("0 0 2 1  2 1 0 0  0 0 2 1"))) == "0 0, 2 1: 0 1 2\n");
}

TEST_CASE("ten thousand copies of a segment are one edge with all sources") {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += i % 2 == 0 ? "0 0 2 1  " : "2 1 0 0  ";
  const ExactComplex complex = arrange(segments(text), ExactEngine::Cgal);
  CHECK(complex.edge_count() == 1);
  CHECK(complex.edge_sources[0].size() == 10000);
  CHECK(arrange(segments(text)) == complex);
}

TEST_CASE("a thousand overlapping collinear segments are a chain of edges") {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += std::to_string(i) + " 0 " + std::to_string(i + 1000) + " 0  ";
  }
  const SegmentSet input = segments(text);
  const ExactComplex complex = arrange(input);
  CHECK(summary(complex) == "V 2000 E 1999 F 1 C 1 antennas 1999");
  CHECK(to_text(validate_coverage(complex, input)) == "");
}

TEST_CASE("two overlapping strokes of a wall divide a square in two") {
  CHECK(arranged(rectangle(0, 0, 3, 3) + "0 1 2 1  1 1 3 1") == "V 8 E 9 F 3 C 1");
}

TEST_CASE("a decimal point on a slanted segment splits it") {
  CHECK(arranged("2 0 0 2  0.4 1.6 5 5") == "V 4 E 3 F 1 C 1 antennas 3");
  CHECK(arranged(".943 .648 1.343 .263  1.023 .571 .543 .573") == "V 4 E 3 F 1 C 1 antennas 3");
}

TEST_CASE("dangling segments inside and outside a square are antennas of their faces") {
  CHECK(arranged(rectangle(0, 0, 4, 4) + "0 2 2 2  4 4 6 6") == "V 7 E 7 F 2 C 1 antennas 2");
}

TEST_CASE("a bridge between a square and its hole joins them to one component") {
  CHECK(arranged(rectangle(0, 0, 9, 9) + rectangle(3, 3, 6, 6) + "0 0 3 3") ==
        "V 8 E 9 F 3 C 1 antennas 1");
}

TEST_CASE("squares that touch in a vertex, outside and inside") {
  CHECK(arranged(rectangle(0, 0, 2, 2) + rectangle(2, 2, 4, 4)) == "V 7 E 8 F 3 C 1");
  CHECK(arranged(rectangle(0, 0, 4, 4) + "0 0 2 1  2 1 2 2  2 2 0 0") == "V 6 E 7 F 3 C 1");
}

TEST_CASE("squares that share part of a side") {
  CHECK(arranged(rectangle(0, 0, 2, 2) + rectangle(2, 1, 4, 3)) == "V 8 E 9 F 3 C 1");
}

TEST_CASE("the axis-parallel room that doubles miss: a wall on a 7 by 11 room") {
  CHECK(arranged(rectangle(0, 0, 7, 11) + "0 1 7 1") == "V 6 E 7 F 3 C 1");
}

TEST_CASE("isolated points belong to the face around them; on an edge they split it") {
  CHECK(arranged(rectangle(0, 0, 4, 4) + "+ 1 1  + 9 9") == "V 6 E 4 F 2 C 3 isolated 2");
  CHECK(arranged("0 0 4 4  + 1 1  + 0 0") == "V 3 E 2 F 1 C 1 antennas 2");
}

TEST_CASE("coordinates up to the limit, and however small, are arranged; beyond, rejected") {
  // A square with a diagonal between the middles of two sides.
  const char* scale = GENERATE("e98", "e-98", "e-400", "e-9000");
  std::string text;
  for (const char* c : {"0 0 8 0", "8 0 8 8", "8 8 0 8", "0 8 0 0", "4 0 0 4"}) {
    std::istringstream words(c);
    for (std::string word; words >> word;) text += word + scale + ' ';
  }
  CHECK(arranged(text) == "V 6 E 7 F 3 C 1");
  const SegmentSet beyond = segments("0 0 1e100 0  0 0 1 1");
  CHECK(beyond.segments.size() == 1);
  REQUIRE(beyond.rejected.size() == 1);
  CHECK(beyond.rejected[0].reason == "a coordinate is beyond 8.7e99");
  SegmentSet unchecked;
  unchecked.segments.push_back({{0, 0}, {parse_decimal("1e100"), 0}});
  CHECK_THROWS_AS(arrange(unchecked), Error);
}

TEST_CASE(
    "lattice segments: valid, and the same for any order, direction, repetition or splitting") {
  const unsigned seed = GENERATE(range(1U, 25U));
  const SegmentSet input = lattice_segments(seed, 40, 9);
  const ExactComplex complex = arrange(input);
  REQUIRE(to_text(validate(complex)) == "");
  REQUIRE(to_text(validate_coverage(complex, input)) == "");
  REQUIRE(arrange(input, ExactEngine::Cgal) == complex);
  std::mt19937 random(seed);

  SegmentSet other = input;
  other.segments = shuffled(input.segments, random);
  CHECK(signature(arrange(other)) == signature(complex));

  other.segments = reversed(input.segments);
  CHECK(signature(arrange(other)) == signature(complex));

  other.segments = joined(input.segments, other.segments);
  CHECK(signature(arrange(other)) == signature(complex));

  // Splitting a segment at one of its vertices changes nothing.
  std::vector<Segment> split = to_vector(input.segments);
  for (std::size_t e = 0; e < complex.edge_count(); e += 3) {
    const Point p = complex.vertices[complex.edges[e].head];
    Segment& s = split[complex.edge_sources[e].front()];
    if (!on_segment(s.a, s.b, p) || p == s.a || p == s.b) continue;
    const Point end = std::exchange(s.b, p);
    split.push_back({p, end});  // invalidates s
  }
  CHECK(split.size() > input.segments.size());
  other.segments = SegmentList(split);
  CHECK(signature(arrange(other)) == signature(complex));
}

TEST_CASE("the arrangement of an affine image is the image of the arrangement") {
  const SegmentSet input = lattice_segments(GENERATE(range(100U, 110U)), 40, 9);
  const ExactComplex complex = arrange(input);
  const auto [name, map] = GENERATE(table<std::string, Affine>({
      {"mirrored", {-1, 0, 0, 1, 0, 0}},
      {"rotated by 90 degrees", {0, 1, -1, 0, 0, 0}},
      {"scaled by 1/3", {Rational(1, 3), 0, 0, Rational(1, 3), 0, 0}},
      {"rotated by a rational angle",
       {Rational(3, 5), Rational(4, 5), Rational(-4, 5), Rational(3, 5), 0, 0}},
      {"sheared and moved", {1, 0, Rational(1, 7), 1, -1000, 5}},
  }));
  CAPTURE(name);
  CHECK(signature(arrange(mapped(input, map))) == signature(affine_image(complex, map)));
}
