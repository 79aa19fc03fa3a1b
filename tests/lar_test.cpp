#include "plumbline/engines/lar.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

lar::Result run(const std::string& text, std::optional<double> radius = std::nullopt) {
  return lar::arrange(segments(text), {radius});
}

std::string counts(const std::string& text, std::optional<double> radius = std::nullopt) {
  return summary(run(text, radius).complex);
}

std::string violations(const FloatComplex& complex) { return to_text(validate(exact(complex))); }

SegmentSet segment_set(const std::vector<std::pair<PointD, PointD>>& ends) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (const auto& [a, b] : ends) set.add(a, b, source);
  return set;
}

const std::string kOrthogonal =
    "0 0 6 0  0 4 10 4  0 0 0 4  3 0 3 4  6 0 6 8  3 2 6 2  10 0 10 8  0 8 10 8";

/// Twelve walls 0.0009 apart between two beams.
std::string chain() {
  std::string text = "-0.5 0 0.5 0  -0.5 1 0.5 1";
  for (int i = 0; i < 12; ++i) {
    const std::string x = std::to_string(9 * i) + "/10000";
    text += "  " + x + " 0 " + x + " 1";
  }
  return text;
}

/// Two walls `gap` apart between two beams.
std::string slot(const std::string& gap) {
  return "0 0 0 1  " + gap + " 0 " + gap + " 1  -1/2 0 1/2 0  -1/2 1 1/2 1";
}

}  // namespace

// Counts from an exact rational arrangement of the same drawings; ids as in the divergence
// catalogue of the original implementation, which gets these wrong.
TEST_CASE("drawings that the original gets wrong have their exact counts") {
  using Row = std::tuple<std::string, std::string, std::string>;
  const auto [id, text, expected] = GENERATE_COPY(table<std::string, std::string, std::string>(
      {Row{"I1 collinear overlap", "0 0 2 0  1 0 3 0", "V 4 E 3 F 1 C 1 antennas 3"},
       Row{"I2 wall of two strokes", rectangle(0, 0, 3, 3) + "0 1 2 1  1 1 3 1", "V 8 E 9 F 3 C 1"},
       Row{"I3 integer T junction", rectangle(0, 0, 7, 11) + "0 1 7 1", "V 6 E 7 F 3 C 1"},
       Row{"I4 corner", "0 0 7 0  7 0 7 11", "V 3 E 2 F 1 C 1 antennas 2"},
       Row{"I5 slanted T junction", "0.943 0.648 1.343 0.263  1.023 0.571 0.543 0.573",
           "V 4 E 3 F 1 C 1 antennas 3"},
       Row{"I6 long cross", "0 0 20 0  6.667 -5 6.667 5", "V 5 E 4 F 1 C 1 antennas 4"},
       Row{"I6 very long cross", "0 0 200000 0  66670 -50000 66670 50000",
           "V 5 E 4 F 1 C 1 antennas 4"},
       Row{"I9 equal heights", "0 0.7 0.5 0.7  1 0.7 1.5 0.7  2 0.7 2.5 0.7",
           "V 6 E 3 F 1 C 3 antennas 3"},
       Row{"F1 bridged rooms", kOrthogonal, "V 13 E 16 F 5 C 1 antennas 2"},
       Row{"F2 most edges are not largest",
           rectangle(0, 0, 100, 100) +
               "200 0 201 0  201 0 201 1  201 1 200.5 1.5  200.5 1.5 200 1  200 1 200 0",
           "V 9 E 9 F 3 C 2"},
       Row{"F3 hole", rectangle(0, 0, 8, 8) + "0 4 8 4  " + rectangle(1, 1, 2, 2),
           "V 10 E 11 F 4 C 2 holes 1 depth 2"},
       Row{"F4 dangling edge", "0 0 1 0  1 0 0 1  0 1 0 0  1 0 2 0", "V 4 E 4 F 2 C 1 antennas 1"},
       Row{"F4 triangles at a vertex",
           "0 0 1.96 0.39  1.96 0.39 -0.63 1.9  -0.63 1.9 0 0  0 0 -0.99 0.34  -0.99 0.34 0.66 "
           "-1.5  0.66 -1.5 0 0",
           "V 5 E 6 F 3 C 1"},
       Row{"F5 square", rectangle(0, 0, 1, 1), "V 4 E 4 F 2 C 1"},
       Row{"F5b nested siblings",
           rectangle(0, 0, 10, 10) + rectangle(1, 1, 4, 4) + rectangle(6, 1, 9, 4) +
               rectangle(2, 2, 3, 3) + rectangle(1, 6, 4, 9),
           "V 20 E 20 F 6 C 5 holes 4 depth 3"},
       Row{"F8 no cycle", "0 0 2 2  0 2 2 0", "V 5 E 4 F 1 C 1 antennas 4"},
       Row{"P4 level vertices",
           "0 -2 2 0  2 0 2.2 0.5  2.2 0.5 0 2  0 2 -2.2 0.5  -2.2 0.5 -2 0  -2 0 0 -2  -0.5 0 0.5 "
           "0  0.5 0 0.5 0.5  0.5 0.5 -0.5 0.5  -0.5 0.5 -0.5 0",
           "V 10 E 10 F 3 C 2 holes 1 depth 2"},
       Row{"P5 touching inside", rectangle(0, 0, 4, 4) + "0 0 2 1  2 1 1 2  1 2 0 0",
           "V 6 E 7 F 3 C 1"},
       Row{"P6 diagonals", rectangle(0, 0, 1, 1) + "0 0 1 1  1 0 0 1", "V 5 E 8 F 5 C 1"},
       Row{"hole touching an edge", rectangle(0, 0, 4, 4) + "2 0 3 1  3 1 1 1  1 1 2 0",
           "V 7 E 8 F 3 C 1"}}));
  INFO(id);
  const lar::Result result = run(text);
  CHECK(summary(result.complex) == expected);
  CHECK(violations(result.complex).empty());
  CHECK(result.trace.settled);
}

TEST_CASE("integer drawings with integer crossings are covered exactly, by the sources named") {
  for (const std::string& text :
       {rectangle(0, 0, 3, 3) + "0 1 2 1  1 1 3 1", rectangle(0, 0, 7, 11) + "0 1 7 1", kOrthogonal,
        rectangle(0, 0, 8, 8) + "0 4 8 4  0 0 8 8  8 0 0 8  1 0 1 9  + 2 7 + 4 4"}) {
    CHECK(to_text(validate_coverage(exact(run(text).complex), segments(text))).empty());
  }
}

TEST_CASE("a grid of m by n lines has the counts of theory") {
  const std::size_t m = 7, n = 12;
  std::string text;
  for (std::size_t i = 1; i <= m; ++i) {
    text += "0 " + std::to_string(i) + "/3 100 " + std::to_string(i) + "/3  ";
  }
  for (std::size_t j = 1; j <= n; ++j) {
    text += std::to_string(j) + "/7 0 " + std::to_string(j) + "/7 100  ";
  }
  const lar::Result result = run(text, 1e-6);
  CHECK(result.complex.vertices.size() == m * n + 2 * m + 2 * n);
  CHECK(result.complex.edge_count() == m * (n + 1) + n * (m + 1));
  CHECK(result.complex.face_count() == (m - 1) * (n - 1) + 1);
  CHECK(violations(result.complex).empty());
}

TEST_CASE("lines through one point share one vertex there, many lines too") {
  for (const int lines : {2, 3, 7, 8, 500}) {
    std::vector<std::pair<PointD, PointD>> ends;
    for (int i = 0; i < lines; ++i) {
      const double x = std::cos(3.14159 * i / lines), y = std::sin(3.14159 * i / lines);
      ends.push_back({{0.3 - x, 0.7 - y}, {0.3 + 2 * x, 0.7 + 2 * y}});
    }
    const lar::Result result = lar::arrange(segment_set(ends), {1e-9});
    CHECK(result.complex.vertices.size() == 2 * static_cast<std::size_t>(lines) + 1);
    CHECK(result.complex.edge_count() == 2 * static_cast<std::size_t>(lines));
    CHECK(result.complex.face_count() == 1);
  }
}

TEST_CASE("squares nested n deep give n faces, each in the one before") {
  std::string text;
  for (int i = 0; i < 30; ++i) text += rectangle(i, i, 100 - i, 100 - i);
  CHECK(counts(text) == "V 120 E 120 F 31 C 30 holes 29 depth 30");
}

TEST_CASE("vertices merge, and edges are led through them, up to the radius and not above") {
  CHECK(counts(slot("1/1000"), 0.00099) == "V 8 E 8 F 2 C 1 antennas 4");
  CHECK(counts(slot("1/1000"), 0.00101) == "V 6 E 5 F 1 C 1 antennas 5");
  CHECK(counts("0 0 4 0  1 0.01 1 2", 0.0099) == "V 4 E 2 F 1 C 2 antennas 2");
  CHECK(counts("0 0 4 0  1 0.01 1 2", 0.0101) == "V 4 E 3 F 1 C 1 antennas 3");
  CHECK(counts("0 0 4 0  1 -0.01 1 2", 0.0099) == "V 5 E 4 F 1 C 1 antennas 4");
  CHECK(counts("0 0 4 0  1 -0.01 1 2", 0.0101) == "V 4 E 3 F 1 C 1 antennas 3");
}

TEST_CASE("Q1: a chain of near vertices merges whole or not at all") {
  CHECK(counts(chain(), 0.00089) == "V 28 E 38 F 12 C 1 antennas 4");
  CHECK(counts(chain(), 0.00091) == "V 6 E 5 F 1 C 1 antennas 5");
}

TEST_CASE(
    "Q4, Q5, Q6: drawings that merging makes non-planar end, and are right below the radius") {
  const std::string q4 =
      "0.0052 0.0029 0.0006 0.004  0.0005 0.0044 0.0026 0.0058  0.0012 0.0053 0.0035 0.0053  0.003 "
      "0.0058 0.0048 0.0025  0.004 0.0022 0.0002 0.0031  0.0009 0.006 0.0024 0.0009";
  const std::string q5 =
      "0.0044 0.0002 0.0045 0.0093  0.0024 0 0.0055 0.0002  0.0027 0.001 0.0051 0.0068  0.0023 "
      "0.0002 0.0078 0.0002  0.0005 0.0027 0.0069 0.0021  0.0091 0.0087 0.0098 0.0069";
  const std::string q6 =
      "0.0046 0.0115 0.012 0.0092  0.0182 0.0052 0.0079 0.0192  0.0117 0.0135 0.0071 0.0071  "
      "0.0143 "
      "0.0153 0.0049 0.0041  0.0098 0.0005 0.0128 0.0158  0.0104 0.0115 0.0193 0.0024  0.019 "
      "0.0116 "
      "0.0125 0.0041";
  CHECK(counts(q4, 1e-6) == "V 18 E 18 F 2 C 1 antennas 13");
  CHECK(counts(q5, 1e-6) == "V 15 E 14 F 2 C 2 antennas 11");
  CHECK(counts(q6, 1e-6) == "V 24 E 27 F 5 C 1 antennas 15");
  for (const std::string& text : {q4, q5, q6}) {
    const lar::Result merged = run(text, 0.001);  // the radius of the original
    CHECK(merged.trace.settled);
    CHECK(violations(merged.complex).empty());
  }
}

TEST_CASE("the default radius grows with the drawing, so that scale and place do not matter") {
  const std::string expected = "V 13 E 16 F 5 C 1 antennas 2";
  const SegmentSet drawn = segments(kOrthogonal);
  for (const double scale : {1e-300, 1e-4, 1.0, 1e9, 1e300}) {
    SegmentSet scaled = drawn;
    scaled.segments = changed(drawn.segments, [&](Segment& s) {
      for (Point* p : {&s.a, &s.b}) *p = {p->x * rational_from(scale), p->y * rational_from(scale)};
    });
    const lar::Result result = lar::arrange(scaled);
    CHECK(summary(result.complex) == expected);
    CHECK(result.trace.radius == Approx(0.01 * scale));
  }
  SegmentSet moved = drawn;
  moved.segments = changed(drawn.segments, [](Segment& s) {
    for (Point* p : {&s.a, &s.b}) *p = {p->x + 1'000'000'000, p->y - 1'000'000'000};
  });
  CHECK(summary(lar::arrange(moved).complex) == expected);
}

TEST_CASE("scaling by a power of two scales the complex, exactly, near overflow too") {
  const SegmentSet drawn = segments("0 0 1 0.3  0.1 0.9 0.7 -0.2  0.3 0.8 0.9 0.1  0 0.5 1 0.4");
  const FloatComplex plain = lar::arrange(drawn).complex;
  for (const int exponent : {-1000, -500, 500, 1000}) {
    SegmentSet scaled = drawn;
    scaled.segments = changed(drawn.segments, [&](Segment& s) {
      for (Point* p : {&s.a, &s.b}) {
        const PointD rounded = nearest(*p);
        *p = exact(PointD{std::ldexp(rounded.x, exponent), std::ldexp(rounded.y, exponent)});
      }
    });
    FloatComplex back = lar::arrange(scaled).complex;
    for (PointD& p : back.vertices) p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent)};
    CHECK(back == plain);
  }
}

TEST_CASE("the whole range of doubles can be arranged") {
  const double big = std::numeric_limits<double>::max();
  const double small = std::numeric_limits<double>::denorm_min();
  const auto cross = [](double c) {
    SegmentSet set;  // beyond what SegmentSet::add accepts
    set.segments = {{exact({-c, -c}), exact({c, c})}, {exact({-c, c}), exact({c, -c})}};
    return summary(lar::arrange(set).complex);
  };
  CHECK(cross(big) == "V 5 E 4 F 1 C 1 antennas 4");
  CHECK(cross(1000 * small) == "V 5 E 4 F 1 C 1 antennas 4");
  CHECK(cross(small) == "V 5 E 4 F 1 C 1 antennas 4");
}

TEST_CASE("a coordinate beyond the largest double is bad input, by name") {
  SegmentSet set = segments("0 0 1 1");
  set.segments.push_back({{0, 0}, {parse_decimal("1e400"), 1}});
  CHECK_THROWS_WITH(lar::arrange(set), Catch::Contains("segment 1") && Catch::Contains("000"));
  set = segments("0 0 1 1");
  set.points.push_back({0, parse_decimal("-1e309")});
  CHECK_THROWS_WITH(lar::arrange(set), Catch::Contains("point 0"));
}

TEST_CASE("the default radius is at most a quarter of the shortest segment, as drawn") {
  // Squares of side 1 in two places far apart.
  const std::string near = "0 0 1 0  1 0 1 1  1 1 0 1  0 1 0 0  ";
  const std::string text =
      near + "90000 0 90001 0  90001 0 90001 1  90001 1 90000 1  90000 1 90000 0";
  const lar::Result result = run(text);
  CHECK(result.trace.radius == 0.25);
  CHECK(result.trace.radius_from_segment);
  CHECK(summary(result.complex) == summary(arrange(segments(text))));
  CHECK(counts(text, 90.001) == "V 0 E 0 F 1 C 0");
  CHECK_FALSE(run(near).trace.radius_from_segment);
  CHECK_FALSE(run(text, 0.25).trace.radius_from_segment);
}

TEST_CASE("the default radius is that of the drawing without what is stray") {
  const std::string house = "0 0 9 0  9 0 9 9  9 9 0 9  0 9 0 0  3 0 3 9  6 0 6 9  ";
  CHECK(run(house + "90000 0 90001 0").trace.radius == run(house).trace.radius);
}

TEST_CASE("a radius that is negative or not finite is bad input") {
  for (const double radius : {-1.0, -1e-300, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(run("0 0 1 1", radius), Error);
  }
}

TEST_CASE("radius 0 still joins what rounding parts") {
  const lar::Result result = run("0 0 1 0.3  0.1 0.9 0.7 -0.2  0.3 0.8 0.9 0.1", 0);
  CHECK(result.trace.radius > 0);
  CHECK(result.trace.radius < 1e-13);
  CHECK(summary(result.complex) ==
        summary(arrange(segments("0 0 1 0.3  0.1 0.9 0.7 -0.2  0.3 0.8 0.9 0.1"))));
}

TEST_CASE("a radius larger than the drawing leaves the unbounded face alone") {
  CHECK(counts(kOrthogonal, 1e308) == "V 0 E 0 F 1 C 0");
  CHECK(counts(kOrthogonal + " + 1 1", 1e308) == "V 1 E 0 F 1 C 1 isolated 1");
}

TEST_CASE("an empty drawing is the unbounded face") {
  const lar::Result result = run("");
  CHECK(summary(result.complex) == "V 0 E 0 F 1 C 0");
  CHECK(result.trace.settled);
}

TEST_CASE("isolated points stay, inside faces, and become vertices of edges that they lie on") {
  const FloatComplex c = run(rectangle(0, 0, 4, 4) + "+ 1 1 + 9 9 + 2 0 + 4 4").complex;
  CHECK(c.vertices.size() == 7);
  CHECK(c.edge_count() == 5);
  CHECK(c.face_isolated_vertices[0].size() == 1);
  CHECK(c.face_isolated_vertices[1].size() == 1);
  CHECK(counts("+ 1 1 + 1 1 + 2 1") == "V 2 E 0 F 1 C 2 isolated 2");
}

TEST_CASE("each edge names all segments that cover it") {
  const FloatComplex c = run("0 0 2 0  3 0 1 0  0 0 2 0  2 0 0 0").complex;
  std::string text;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    for (SegmentId s : c.edge_sources[e]) text += std::to_string(s) + ' ';
    text += '\n';
  }
  CHECK(text == "0 2 3 \n0 1 2 3 \n1 \n");
}

TEST_CASE("the complex does not depend on order, direction and repetition of the segments") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(0, 1);
  for (int drawing = 0; drawing < 20; ++drawing) {
    std::vector<std::pair<PointD, PointD>> ends;
    for (int i = 0; i < 60; ++i) {
      ends.push_back({{at(random), at(random)}, {at(random), at(random)}});
    }
    FloatComplex first = lar::arrange(segment_set(ends)).complex;
    for (std::size_t i = 0; i < 20; ++i) ends.push_back(ends[3 * i]);
    std::shuffle(ends.begin(), ends.end(), random);
    for (std::size_t i = 0; i < ends.size(); i += 2) std::swap(ends[i].first, ends[i].second);
    FloatComplex second = lar::arrange(segment_set(ends)).complex;
    first.edge_sources = second.edge_sources = {};
    CHECK(first == second);
  }
}

TEST_CASE("random drawings give valid complexes at every radius") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(0, 1);
  for (int drawing = 0; drawing < 60; ++drawing) {
    std::vector<std::pair<PointD, PointD>> ends;
    const bool thousandths = drawing % 2 != 0;  // many ties with a radius of one thousandth
    const auto coordinate = [&] {
      return thousandths ? std::floor(4 * at(random)) + std::floor(3 * at(random)) / 1000
                         : at(random);
    };
    for (int i = 0; i < 40; ++i) {
      ends.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    }
    for (const double radius : {0.0, 1e-9, 1e-3, 0.02, 0.3}) {
      const lar::Result result = lar::arrange(segment_set(ends), {radius});
      CHECK(result.trace.settled);
      CHECK(violations(result.complex).empty());
    }
  }
}

TEST_CASE("random drawings agree with the exact arrangement where nothing is within the radius") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 1);
  for (int drawing = 0; drawing < 20; ++drawing) {
    std::vector<std::pair<PointD, PointD>> ends;
    for (int i = 0; i < 50; ++i) {
      ends.push_back({{at(random), at(random)}, {at(random), at(random)}});
    }
    const SegmentSet input = segment_set(ends);
    const FloatComplex rounded = lar::arrange(input, {1e-11}).complex;
    const ExactComplex exact_complex = arrange(input);
    CHECK(static_cast<const Incidences&>(rounded) == exact_complex);
  }
}

TEST_CASE("the trace has the components, bridges and areas of the drawing") {
  const lar::Trace trace = run(kOrthogonal).trace;
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < trace.biconnected.size(); ++i) {
    sizes.push_back(trace.biconnected[i].size());
  }
  std::sort(sizes.begin(), sizes.end());
  CHECK(sizes == std::vector<std::size_t>{4, 10});
  CHECK(trace.bridges.size() == 2);
  std::vector<double> areas = trace.cycle_areas;
  std::sort(areas.begin(), areas.end());
  CHECK(areas == std::vector<double>{-40, 6, 6, 12, 16});
}

TEST_CASE("a very long path needs no stack, and near duplicates and outliers no quadratic time") {
  std::vector<std::pair<PointD, PointD>> ends;
  for (int i = 0; i < 200'000; ++i) {
    ends.push_back({{double(i), double(i % 7)}, {i + 1.0, double((i + 1) % 7)}});
  }
  CHECK(summary(lar::arrange(segment_set(ends), {0.1}).complex) ==
        "V 200001 E 200000 F 1 C 1 antennas 200000");
  // This radius takes in hundreds of vertices: all merge into one.
  CHECK(summary(lar::arrange(segment_set(ends), {200}).complex) == "V 0 E 0 F 1 C 0");

  ends.assign(1000, {{0, 0}, {1, 0}});
  for (int i = 0; i < 1000; ++i) ends.push_back({{0.5, 1}, {0.5, -1 - 1e-9 * i}});
  CHECK(summary(lar::arrange(segment_set(ends)).complex) == "V 5 E 4 F 1 C 1 antennas 4");

  ends.clear();
  for (int i = 0; i < 50'000; ++i) {
    const double x = i % 250, y = i / 250;
    ends.push_back({{x, y}, {x + 0.5, y + 0.5}});
  }
  for (int i = 0; i < 5; ++i) ends.push_back({{1e6 + i, 0}, {1e6 + i, 1}});
  CHECK(lar::arrange(segment_set(ends), {0.01}).complex.component_count() == 50'005);
}
