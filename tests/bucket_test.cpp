// The bucket engine against the reference and against facts.

#include <catch2/catch.hpp>

#include <cmath>

#include "arrange/bucket/buckets.hpp"
#include "arrange/bucket/grid_kernel.hpp"
#include "arrange/bucket/rational_kernel.hpp"
#include "plumbline/arrange.hpp"
#include "random_segments.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Arranges by buckets, compares with the reference, returns the summary.
std::string arranged(const SegmentSet& input) {
  const ExactComplex complex = arrange(input, Engine::Bucket);
  CHECK(to_text(validate(complex)) == "");
  CHECK(to_text(validate_coverage(complex, input)) == "");
  CHECK(complex == arrange(input, Engine::Cgal));
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

TEST_CASE("both engines return the same complex on every family of random segments") {
  const std::string family = GENERATE(
      from_range(std::begin(random_segments::kFamilies), std::end(random_segments::kFamilies)));
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(family, seed);
    const SegmentSet input = random_segments::make(family, seed);
    REQUIRE(arrange(input, Engine::Bucket) == arrange(input, Engine::Cgal));
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
  CHECK(arrange(segments(text + "4 0 4 4"), Engine::Bucket).edge_sources[0].size() == 1000);
}

TEST_CASE("buckets: n lines through one point of thirds have 2n + 1 vertices") {
  const ExactComplex complex = arrange(pencil(3000), Engine::Bucket);
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
  for (int i = 0; i < 1000; ++i)
    text += std::to_string(i) + " -1/1000 " + std::to_string(i) + " 1/1000  ";
  CHECK(arranged(text) == "V 3002 E 3001 F 1 C 1 antennas 3001");
}

// Regression: a ray stopped at a line too steep for doubles to tell its height. Expected counts
// from validation/facts/arrangement.py.
TEST_CASE("buckets: a component beside a line that is all but vertical has its face") {
  const std::string d = "/1000000000000000000000000000057 ";
  CHECK(arranged("0 4 9000000000000000000000000000514" + d + "8  1 7 0 3  9 2 1 7  " +
                 "1 6 1000000000000000000000000000059" + d + "10  7 2 7 5  9 11 1 11")
            .substr(0, 17) == "V 15 E 14 F 2 C 2");
}

TEST_CASE("coordinates that share a decimal grid of 60 bits are integers, others rationals") {
  CHECK(bucket::GridKernel::from(segments("0.1 0.25 57646075230342348.75 3")).has_value());
  CHECK_FALSE(bucket::GridKernel::from(segments("0.1 0.25 57646075230342348.8 3")).has_value());
  CHECK_FALSE(bucket::GridKernel::from(segments("0 0 1e-19 3")).has_value());
  CHECK(bucket::GridKernel::from(segments("1/3 1/7 1/11 3")).has_value());
}

TEST_CASE("both kernels decide alike at the limit of the grid") {
  // Ends one unit of the grid off a long slanted line, and on it.
  const std::string text =
      "-1152921504606846975 -1152921504606846975 1152921504606846975 1152921504606846974 "
      "0 0 1 1  -1 0 0 -1  -1152921504606846974 -1152921504606846974 5 5  0 -1/2 9 9";
  const auto decide = [](const auto& kernel) {
    std::string decisions;
    for (bucket::LineId s = 0; s < kernel.size(); ++s) {
      for (bucket::EndId e = 0; e < 2 * kernel.size(); ++e) {
        decisions +=
            std::to_string(kernel.side(s, e)) + std::to_string(kernel.orientation(s, e).sign);
      }
    }
    return decisions;
  };
  const auto integers = segments(
      "-1152921504606846975 -1152921504606846975 1152921504606846975 1152921504606846974 "
      "0 0 1 1  -1 0 0 -1  -1152921504606846974 -1152921504606846974 5 5");
  const auto grid = bucket::GridKernel::from(integers);
  REQUIRE(grid.has_value());
  CHECK(decide(*grid) == decide(bucket::RationalKernel::from(integers)));
  CHECK(arranged(text).substr(0, 17) == "V 12 E 11 F 1 C 1");
}

TEST_CASE("the double filter is right where a point is next to a line by one rounding") {
  // r = p + t (q - p), rounded to doubles and moved by single roundings: exact orientation decides.
  const auto kernel_of = [](const Point& p, const Point& q, const Point& r) {
    SegmentSet set;
    const SourceId source = set.add_source({});
    set.segments = {{p, q}, {r, {1000, 1000}}};
    set.segment_source = {source, source};
    return bucket::RationalKernel::from(set);
  };
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    PointD p{coordinate(random), coordinate(random)}, q{coordinate(random), coordinate(random)};
    if (q < p) std::swap(p, q);
    const double t = std::abs(coordinate(random));
    for (int step = -2; step <= 2; ++step) {
      PointD r{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      for (int k = 0; k < std::abs(step); ++k) r.y = std::nextafter(r.y, step < 0 ? -9 : 9);
      const auto kernel = kernel_of(exact(p), exact(q), exact(r));
      const int expected = orientation(exact(p), exact(q), exact(r));
      REQUIRE(kernel.side(0, 2) == expected);
      REQUIRE(kernel.orientation(0, 2).sign == expected);
    }
  }
}

TEST_CASE("products of 128-bit numbers are compared exactly") {
  using bucket::compare_products;
  const bucket::Int128 big = (bucket::Int128(1) << 125) + 12345;
  CHECK(compare_products(big, big, big + 1, big - 1) == 1);
  CHECK(compare_products(big + 1, big - 1, big, big) == -1);
  CHECK(compare_products(big, -big, -big, big) == 0);
  CHECK(compare_products(-big, -big, big - 1, big + 1) == 1);
  CHECK(compare_products(0, big, 1, -1) == 1);
}

TEST_CASE("every point is in one bucket, and all lines near it are listed there") {
  const SegmentSet input = random_segments::make("lattice", 7);
  const auto kernel = *bucket::GridKernel::from(input);
  std::vector<bucket::Approx> approx;
  for (bucket::LineId s = 0; s < kernel.size(); ++s) approx.push_back(kernel.approx(s));
  const bucket::Buckets buckets(approx, 1e-9);
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
