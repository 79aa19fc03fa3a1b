// The bucket engine against the reference and against facts.

#include <catch2/catch.hpp>

#include <cmath>

#include "arrange/bucket/buckets.hpp"
#include "arrange/bucket/filtered_kernel.hpp"
#include "arrange/bucket/grid_kernel.hpp"
#include "arrange/bucket/split.hpp"
#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Arranges by buckets, compares with the reference, returns the summary.
std::string arranged(const SegmentSet& input) {
  const ExactComplex complex = arrange(input, ExactEngine::Bucket);
  CHECK(to_text(validate(complex)) == "");
  CHECK(to_text(validate_coverage(complex, input)) == "");
  CHECK(complex == arrange(input, ExactEngine::Cgal));
  return summary(complex);
}

std::string arranged(const std::string& text) { return arranged(segments(text)); }

/// n lines through (1/3, 2/3), given at both ends.
SegmentSet pencil(int n) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (int i = 1; i <= n; ++i) {
    const Point a{i * i - 7 * i, 1000 - 3 * i};
    set.add({a, {Rational(2, 3) - a.x, Rational(4, 3) - a.y}}, source);
  }
  return set;
}

}  // namespace

namespace {

bucket::Job serial() { return bucket::Job(1, {}); }

}  // namespace

TEST_CASE("both engines return the same complex on every family of random segments") {
  const std::string family = GENERATE(from_range(inputs::families()));
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(family, seed);
    const SegmentSet input = inputs::of_family(family, seed);
    REQUIRE(arrange(input, ExactEngine::Bucket) == arrange(input, ExactEngine::Cgal));
  }
}

TEST_CASE("buckets: empty, one segment, one point") {
  CHECK(arranged("") == "V 0 E 0 F 1 C 0");
  CHECK(arranged("0 0 3 1") == "V 2 E 1 F 1 C 1 antennas 1");
  CHECK(arranged("+ 0 0") == "V 1 E 0 F 1 C 1 isolated 1");
  CHECK(arranged("+ 5 7  + 5 7  5 7 6 7") == "V 2 E 1 F 1 C 1 antennas 1");
}

TEST_CASE("buckets: isolated points in faces, on edges, on crossings") {
  CHECK(arranged(rectangle(0, 0, 4, 4) + "+ 1 1  + 9 9  + 2 0  + 4 4") ==
        "V 7 E 5 F 2 C 3 isolated 2");
  CHECK(arranged("0 0 2 2  0 2 2 0  + 1 1") == "V 5 E 4 F 1 C 1 antennas 4");
}

TEST_CASE("buckets: a thousand copies of a wall are one wall") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += i % 2 == 0 ? "0 0 9 1  " : "9 1 0 0  ";
  CHECK(arrange(segments(text + "4 0 4 4"), ExactEngine::Bucket).edge_sources[0].size() == 1000);
}

TEST_CASE("buckets: n lines through one point of thirds have 2n + 1 vertices") {
  const ExactComplex complex = arrange(pencil(3000), ExactEngine::Bucket);
  CHECK(summary(complex) == "V 6001 E 6000 F 1 C 1 antennas 6000");
  CHECK(arranged(pencil(200)) == "V 401 E 400 F 1 C 1 antennas 400");
}

TEST_CASE("buckets: a pencil with a segment that ends in its centre, and with collinear members") {
  SegmentSet set = pencil(100);
  const SourceId source = set.add_source({});
  const Point centre{Rational(1, 3), Rational(2, 3)};
  set.add({centre, {5000, 17}}, source);
  CHECK(arranged(set) == "V 202 E 201 F 1 C 1 antennas 201");
  const Segment s = set.segments[40];
  set.add(
      {{(s.a.x + centre.x) / 2, (s.a.y + centre.y) / 2}, {2 * s.b.x - s.a.x, 2 * s.b.y - s.a.y}},
      source);
  CHECK(arranged(set) == "V 204 E 203 F 1 C 1 antennas 203");
}

TEST_CASE("buckets: a hatch of parallel slanted lines crosses nothing") {
  std::string text;
  for (int i = 0; i < 400; ++i) {
    text += std::to_string(i) + " 0 " + std::to_string(i + 4000) + " 3000  ";
  }
  CHECK(arranged(text) == "V 800 E 400 F 1 C 400 antennas 400");
}

TEST_CASE("buckets: one long line through many short ones") {
  std::string text = "-1 0 1001 0  ";
  for (int i = 0; i < 1000; ++i) {
    text += std::to_string(i) + " -1/1000 " + std::to_string(i) + " 1/1000  ";
  }
  CHECK(arranged(text) == "V 3002 E 3001 F 1 C 1 antennas 3001");
}

// Regression: a ray stopped at a line too steep for doubles to tell its height. Expected counts
// from tests/regressions/counts.py.
TEST_CASE("buckets: a component beside a line that is all but vertical has its face") {
  const std::string d = "/1000000000000000000000000000057 ";
  CHECK(arranged("0 4 9000000000000000000000000000514" + d + "8  1 7 0 3  9 2 1 7  " +
                 "1 6 1000000000000000000000000000059" + d + "10  7 2 7 5  9 11 1 11")
            .substr(0, 17) == "V 15 E 14 F 2 C 2");
}

// Regression: CGAL's default point location never ended here.
TEST_CASE("a point on a vertical antenna that hangs into nested rooms splits it") {
  const std::string diamond = "0 -20 20 0  20 0 0 20  0 20 -20 0  -20 0 0 -20  ";
  CHECK(arranged(diamond + rectangle(-1, -1, 1, 1) + "0 40 0 0  + 0 1/2") ==
        "V 12 E 13 F 3 C 1 antennas 4");
}

// Regression: the slope of such a line is infinite in doubles, and its cells were no number.
TEST_CASE("buckets: a line that all but level crosses the rows of the grid") {
  CHECK(arranged("-1 -1e-315 1 1e-315  -1 -1 -19/20 -1  19/20 1 1 1  -1/2 -1/10 -1/2 1/10") ==
        "V 9 E 6 F 1 C 3 antennas 6");
}

// Regression: looking for the sources of an edge went through all parts of its line.
TEST_CASE("buckets: bricks, each overlapping the next, are covered by one or two") {
  SegmentSet input;
  const SourceId source = input.add_source({});
  for (int i = 0; i < 200; ++i) input.add({{2 * i, 0}, {2 * i + 3, 0}}, source);
  const ExactComplex complex = arrange(input);
  CHECK(complex == arrange(input, ExactEngine::Cgal));
  CHECK(complex.edge_sources[0].size() == 1);
  CHECK(complex.edge_sources[1].size() == 2);
  CHECK(complex.edge_sources.flat().size() == 598);  // three each, the first and the last two
}

// Regression: doubles near 0 have absolute errors, which no margin knew of.
TEST_CASE("buckets: a drawing of 1e-315 of the extent is arranged as a large one") {
  const Rational unit = parse_decimal("1e-315");
  SegmentSet input;
  const SourceId source = input.add_source({});
  for (int i = 0; i < 60; ++i) {
    input.add({{0, i * unit}, {59 * unit, i * unit}}, source);
    input.add({{i * unit, 0}, {i * unit, 59 * unit}}, source);
  }
  input.add({{Rational(3, 10), Rational(3, 10)}, {Rational(2, 5), Rational(1, 2)}}, source);
  CHECK(summary(arrange(input)) == "V 3602 E 7081 F 3482 C 2 antennas 1");
}

TEST_CASE("buckets: ends on a line of 1e-323 are in their order along it") {
  const Rational unit = parse_decimal("1e-324");
  SegmentSet input;
  const SourceId source = input.add_source({});
  const Point a{0, 0}, b{70 * unit, 31 * unit};
  input.add({a, b}, source);
  for (int k = 1; k < 97; k += 3) {  // through the line, or from it, at k / 97
    const Point foot{b.x * k / 97, b.y * k / 97};
    const Point off{Rational(k % 7 - 3) * unit, Rational(k % 5 + 1) * unit};
    input.add({k % 2 == 0 ? Point{foot.x - off.x, foot.y - off.y} : foot,
               {foot.x + off.x, foot.y + off.y}},
              source);
  }
  input.add({{Rational(3, 10), Rational(3, 10)}, {Rational(2, 5), Rational(1, 2)}}, source);
  CHECK(arrange(input, ExactEngine::Bucket) == arrange(input, ExactEngine::Cgal));
}

TEST_CASE("buckets: isolated points, however many and wherever, have their faces") {
  std::string column, inside = rectangle(-1, -1, 1, 400) + rectangle(-5, -5, 5, 500);
  for (int i = 0; i < 300; ++i) column += "+ 0 " + std::to_string(i) + "  ";
  CHECK(arranged(column) == "V 300 E 0 F 1 C 300 isolated 300");
  CHECK(arranged(inside + column + "+ 3 3  + 7 7  + 3 400") ==
        "V 311 E 8 F 3 C 305 holes 1 isolated 303 depth 2");
}

TEST_CASE("far from the origin, a drawing is arranged as near it") {
  for (const char* offset : {"10000000000000000000", "-1000000000000000000000/7"}) {
    SegmentSet near = inputs::of_family("lattice", 11), far;
    const SourceId source = far.add_source({});
    const Rational d(offset);
    for (const Segment& s : near.segments) {
      far.add({{s.a.x + d, s.a.y - d}, {s.b.x + d, s.b.y - d}}, source);
    }
    for (const Point& p : near.points) far.add_point({p.x + d, p.y - d}, source);
    ExactComplex moved = arrange(far);
    for (std::size_t v = 0; v < moved.vertices.size(); ++v) {
      moved.vertices.replace(v, {moved.vertices[v].x - d, moved.vertices[v].y + d});
    }
    CHECK(moved == arrange(near));
  }
}

TEST_CASE("the families of full places fill buckets with more lines than are tested pair by pair") {
  for (const char* family : {"pencils", "near pencils", "fan", "hatch", "pencil in a bundle",
                             "stars on a small lattice"}) {
    int full = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
      bucket::Job job = serial();
      const bucket::FilteredKernel kernel(inputs::of_family(family, seed), job);
      std::vector<bucket::Approx> approx;
      for (bucket::LineId s = 0; s < kernel.size(); ++s) approx.push_back(kernel.approx(s));
      const bucket::Buckets buckets(approx, 1e-9, job);
      bool any = false;
      for (std::size_t b = 0; b < buckets.size(); ++b) {
        any = any || buckets.lines(b).size() > bucket::kFullBucket;
      }
      full += any;
    }
    CAPTURE(family, full);
    CHECK(full >= 2);
  }
}

TEST_CASE("every point is in one bucket, and all lines near it are listed there") {
  const SegmentSet input = inputs::of_family("lattice", 7);
  bucket::Job job = serial();
  const bucket::GridKernel kernel(*bucket::GridInput::from(input, job));
  std::vector<bucket::Approx> approx;
  for (bucket::LineId s = 0; s < kernel.size(); ++s) approx.push_back(kernel.approx(s));
  const bucket::Buckets buckets(approx, 1e-9, job);
  for (bucket::LineId s = 0; s < approx.size(); ++s) {
    for (int k = 0; k <= 100; ++k) {
      const double t = k / 100.0;
      const std::size_t b = buckets.bucket_at(approx[s].ax + t * (approx[s].bx - approx[s].ax),
                                              approx[s].ay + t * (approx[s].by - approx[s].ay));
      const auto lines = buckets.lines(b);
      CHECK(std::find(lines.begin(), lines.end(), s) != lines.end());
    }
  }
}

TEST_CASE("the arrangement's numbering does not depend on the number of threads") {
  for (const char* family : {"lattice", "collinear", "rotated lattice", "rings"}) {
    SegmentSet input;
    const SourceId source = input.add_source({});
    for (unsigned seed = 1; seed <= 300; ++seed) {
      const SegmentSet part = inputs::of_family(family, seed);
      const Rational dx = static_cast<int>(seed % 17) * 9, dy = static_cast<int>(seed / 17) * 9;
      for (const Segment& s : part.segments) {
        input.add({{s.a.x + dx, s.a.y + dy}, {s.b.x + dx, s.b.y + dy}}, source);
      }
    }
    const Arrangement one(input, {1, {}});
    for (const std::size_t threads : {2U, 5U}) {
      const Arrangement many(input, {threads, {}});
      REQUIRE(many.edge_count() == one.edge_count());
      REQUIRE(many.cycle_count() == one.cycle_count());
      bool same = true;
      for (std::size_t h = 0; h < 2 * one.edge_count(); ++h) {
        const HalfedgeId id(h);
        same = same && many.next(id) == one.next(id) && many.cycle(id) == one.cycle(id) &&
               many.edge(edge_of(id)) == one.edge(edge_of(id)) &&
               many.face(many.cycle(id)) == one.face(one.cycle(id));
      }
      CHECK(same);
      CHECK(many.complex() == one.complex());
    }
  }
}

TEST_CASE("a progress callback sees the work from 0 to 1 and can end it") {
  const SegmentSet input = pencil(2000);
  std::vector<double> seen;
  const Arrangement arrangement(input, {2, [&](double part) {
                                          seen.push_back(part);
                                          return true;
                                        }});
  CHECK(std::is_sorted(seen.begin(), seen.end()));
  CHECK(seen.front() >= 0);
  CHECK(seen.back() > 0.9);
  CHECK(seen.back() <= 1);
  try {
    const Arrangement cancelled(input, {2, [](double part) { return part < 0.5; }});
    FAIL("not cancelled");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::Cancelled);
  }
}
