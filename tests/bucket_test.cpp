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

std::string kernel_of(const std::string& text) {
  bucket::Job job = serial();
  const auto grid = bucket::GridInput::from(segments(text), job);
  if (!grid) return "weighted";
  return bucket::GridKernel::fits(*grid) ? "narrow" : "wide";
}

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
  CHECK(kernel_of("10000000000000000000 5 10000000000000000001 6") == "narrow");
}

namespace {

/// What a kernel decides about all pairs of its lines.
template <class Kernel>
std::string decisions(const Kernel& kernel) {
  std::string text;
  const auto add = [&](int value) { text += std::to_string(bucket::sign(value)); };
  for (bucket::LineId s = 0; s < kernel.size(); ++s) {
    for (bucket::LineId o = 0; o < kernel.size(); ++o) {
      if (o == s) continue;
      const bucket::Relation r = kernel.relate(s, o);
      add(r.apart());
      if (r.apart()) continue;
      for (const int sign : {r.a_to_s, r.b_to_s, r.a_to_o, r.b_to_o, kernel.side(s, 2 * o),
                             kernel.compare_directions(s, o), kernel.compare(2 * s, 2 * o + 1)}) {
        add(sign);
      }
      if (!r.cross()) continue;
      CHECK(r.at_s == Approx(kernel.parameter(s, o)).epsilon(1e-8));
      for (bucket::LineId q = 0; q < kernel.size(); ++q) {
        add(kernel.side_of_crossing(q, s, o));
        add(kernel.compare_x(s, o, 2 * q));
        if (q != s && q != o && kernel.relate(s, q).cross()) {
          add(kernel.compare_along(s, o, q));
        }
      }
    }
  }
  return text;
}

}  // namespace

TEST_CASE("coordinates that share a grid of 124 bits are integers on it, others fractions") {
  CHECK(kernel_of("0.1 0.25 57646075230342348.75 3") == "wide");
  CHECK(kernel_of("0 0 1e-19 3") == "wide");
  CHECK(kernel_of("0.30000000000000004 0.1 6.123233995736766e-17 1000") == "wide");
  CHECK(kernel_of("1/3 1/7 1/11 3") == "narrow");
  // 2^125 apart, and one more.
  CHECK(kernel_of("0 0 42535295865117307932921825928971026430 3") == "wide");
  CHECK(kernel_of("0 0 42535295865117307932921825928971026432 3") == "weighted");
  CHECK(kernel_of("0 0 1e-40 3") == "weighted");
}

TEST_CASE("the grid holds numbers of all kinds, near the origin and far from it") {
  for (const char* offset : {"0", "1e40", "-12345678901234567890123456789012345678901/7"}) {
    const Rational d = Rational(parse_decimal(offset));
    SegmentSet set;
    const SourceId source = set.add_source({});
    const std::vector<Segment> drawn = {
        {{d + Rational(1, 3), d}, {d + 2, d + Rational(5, 4)}},
        {{d, d - 1}, {d, d + 1}},
        {{d + Rational(-7, 1000), d}, {d + 9, d - Rational(1, 21)}}};
    for (const Segment& s : drawn) set.add(s, source);
    bucket::Job job = serial();
    const auto grid = bucket::GridInput::from(set, job);
    REQUIRE(grid.has_value());
    const bucket::FilteredKernel kernel(*grid, job);
    for (std::size_t s = 0; s < drawn.size(); ++s) {
      const auto line = static_cast<bucket::LineId>(s);
      CHECK(kernel.point(bucket::first_end(line)) == std::min(drawn[s].a, drawn[s].b));
      CHECK(kernel.point(bucket::last_end(line)) == std::max(drawn[s].a, drawn[s].b));
    }
    CHECK(kernel.crossing(0, 2) == bucket::FilteredKernel(set, job).crossing(0, 2));
  }
}

TEST_CASE("a drawing of 31 bits is narrow wherever it lies") {
  CHECK(kernel_of("0 0 2147483646 5") == "narrow");
  CHECK(kernel_of("0 0 2147483648 5") == "wide");
  CHECK(kernel_of("500000000000000000 0 500000002147483646 5") == "narrow");
  CHECK(kernel_of("-1073741823 0 1073741823 -1073741823  0 0 1 1073741823") == "narrow");
}

namespace {

/// The exact arithmetic of each kind of number, without filter.
struct ExactKernels {
  explicit ExactKernels(const SegmentSet& input) {
    bucket::Job job = serial();
    const bucket::GridInput grid = *bucket::GridInput::from(input, job);
    std::vector<bucket::ExactLines<mpz_class>::Line> lines;
    for (const auto& line : grid.lines) {
      const mpz_class weight(static_cast<int>(lines.size() % 3 + 1));
      lines.emplace_back();
      for (std::size_t k = 0; k < line.size(); ++k) {
        lines.back()[k] = bucket::to_mpz(line[k]) * weight;
      }
      lines.back()[4] = weight;
    }
    wide = {grid.lines, grid.frame};
    weighted = {lines, grid.frame};
  }
  bucket::ExactLines<bucket::Int128> wide;
  bucket::ExactLines<mpz_class> weighted;
};

/// An exact kernel as one that also relates pairs, by its sides alone.
template <class Lines>
struct Sides : Lines {
  explicit Sides(const Lines& lines) : Lines(lines) {}
  bucket::Relation relate(bucket::LineId s, bucket::LineId o) const {
    bucket::Relation r{this->side(s, 2 * o), this->side(s, 2 * o + 1), this->side(o, 2 * s),
                       this->side(o, 2 * s + 1)};
    if (r.cross()) {
      r.at_s = this->parameter(s, o);
      r.at_o = this->parameter(o, s);
    }
    return r;
  }
};

}  // namespace

TEST_CASE("all kernels decide alike at the limits of their grids") {
  // Ends one unit of the grid off a long slanted line, and on it.
  const auto [big, less] = GENERATE(table<std::string, std::string>(
      {{"1073741823", "1073741822"},
       {"1152921504606846975", "1152921504606846974"},
       {"21267647932558653966460912964485513215", "21267647932558653966460912964485513214"}}));
  const std::string text = "-" + big + " -" + big + " " + big + " " + less +
                           "  0 0 1 1  -1 0 0 -1  -" + less + " -" + less + " 5 5  -" + big + " " +
                           big + " " + big + " -" + big + "  -" + less + " " + big + " " + big +
                           " -" + less;
  CAPTURE(text);
  bucket::Job job = serial();
  const SegmentSet input = segments(text);
  const auto grid = bucket::GridInput::from(input, job);
  REQUIRE(grid.has_value());
  const ExactKernels exact(input);
  const std::string expected = decisions(Sides(exact.weighted));
  CHECK(decisions(Sides(exact.wide)) == expected);
  CHECK(decisions(bucket::FilteredKernel(*grid, job)) == expected);
  CHECK(decisions(bucket::FilteredKernel(input, job)) == expected);
  if (bucket::GridKernel::fits(*grid)) CHECK(decisions(bucket::GridKernel(*grid)) == expected);
  arranged(text);
}

TEST_CASE("all kernels decide alike on every family of random segments") {
  const std::string family = GENERATE(from_range(inputs::families()));
  for (unsigned seed = 1; seed <= 3; ++seed) {
    CAPTURE(family, seed);
    const SegmentSet input = inputs::of_family(family, seed);
    bucket::Job job = serial();
    const std::string expected = decisions(bucket::FilteredKernel(input, job));
    const auto grid = bucket::GridInput::from(input, job);
    if (!grid) continue;
    CHECK(decisions(bucket::FilteredKernel(*grid, job)) == expected);
    const ExactKernels exact(input);
    CHECK(decisions(Sides(exact.wide)) == expected);
    CHECK(decisions(Sides(exact.weighted)) == expected);
  }
}

TEST_CASE("lines on one supporting line have one key, whatever the kernel") {
  const SegmentSet input = segments(
      "0 1/3 3 4/3  6 7/3 9 10/3  -3 -2/3 0 1/3  7 0 7 1  7 5 7 9  0 0 5 0  8 0 9 0  1 1 2 2 + 2 2 "
      "+ 2 2");
  bucket::Job job = serial();
  const auto keys_of = [](const auto& kernel) {
    std::vector<std::uint64_t> keys(kernel.size());
    kernel.keys(0, keys.size(), keys.data());
    return keys;
  };
  const auto grid = bucket::GridInput::from(input, job);
  for (const auto& k :
       {keys_of(bucket::GridKernel(*grid)), keys_of(bucket::FilteredKernel(*grid, job)),
        keys_of(bucket::FilteredKernel(input, job))}) {
    CHECK((k[0] == k[1] && k[1] == k[2]));
    CHECK(k[3] == k[4]);
    CHECK(k[5] == k[6]);
    CHECK(k[8] == k[9]);
    std::vector<std::uint64_t> different{k[0], k[3], k[5], k[7], k[8]};
    std::sort(different.begin(), different.end());
    CHECK(std::unique(different.begin(), different.end()) == different.end());
  }
}

TEST_CASE("the double filter is right where a point is next to a line by one rounding") {
  // r = p + t (q - p), rounded to doubles and moved by single roundings: exact orientation decides.
  const auto kernel_with = [](const Point& p, const Point& q, const Point& r) {
    SegmentSet set;
    const SourceId source = set.add_source({});
    set.add(Segment{p, q}, source);
    set.add(Segment{r, {1000, 1000}}, source);
    bucket::Job job = serial();
    return bucket::FilteredKernel(set, job);
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
      const auto kernel = kernel_with(exact(p), exact(q), exact(r));
      const int expected = orientation(exact(p), exact(q), exact(r));
      REQUIRE(kernel.side(0, 2) == expected);
      REQUIRE(kernel.relate(0, 1).a_to_s == expected);
    }
  }
}

TEST_CASE("integers of 256 bits are added, multiplied and compared as GMP does") {
  using bucket::Int128, bucket::Int256, bucket::to_mpz;
  std::mt19937_64 random(3);
  const auto integer = [&] {  // of any length, often next to a power of two
    const auto high = static_cast<Int128>(random()) << 62U | random();
    const Int128 v =
        (high >> static_cast<int>(random() % 126)) + static_cast<int>(random() % 3) - 1;
    return random() % 2 == 0 ? v : -v;
  };
  for (int i = 0; i < 20000; ++i) {
    const Int128 a = integer(), b = integer(), c = integer(), d = integer();
    const Int256 p = bucket::product(a, b), q = bucket::product(c, d);
    const mpz_class m = to_mpz(a) * to_mpz(b), n = to_mpz(c) * to_mpz(d);
    REQUIRE(to_mpz(p) == m);
    REQUIRE(to_mpz(p + q) == m + n);
    REQUIRE(to_mpz(p - q) == m - n);
    REQUIRE(bucket::to_int256(m) == p);
    REQUIRE(bucket::sign(p) == sgn(m));
    REQUIRE((p < q) == (m < n));
    REQUIRE(bucket::to_double(p) == Approx(m.get_d()).epsilon(1e-15));
    REQUIRE(compare_products(p, q, q, p) == 0);
    REQUIRE(compare_products(p, q, q + 1, p) == bucket::sign(mpz_class(m * n - (n + 1) * m)));
    REQUIRE(compare_products(p, p, q, q) == bucket::sign(mpz_class(m * m - n * n)));
  }
}

TEST_CASE("a line whose width is the prime of the keys has the key of its neighbours") {
  // dx is the prime 2^61 - 1, a multiple of it, or one that dy cancels.
  const std::string p = "2305843009213693951", p2 = "4611686018427387902";
  const SegmentSet input =
      segments("0 0 " + p + " 3  " + p + " 3 " + p2 + " 6  0 1 " + p + " " + p +
               "  5 6 7 8  0 7 0 9  + " + p + " 3  0 1/" + p + " 1 1/" + p);
  bucket::Job job = serial();
  const auto grid = bucket::GridInput::from(input, job);
  REQUIRE(grid.has_value());
  for (const bucket::FilteredKernel& kernel :
       {bucket::FilteredKernel(*grid, job), bucket::FilteredKernel(input, job)}) {
    std::vector<std::uint64_t> keys(kernel.size());
    kernel.keys(0, keys.size(), keys.data());
    CHECK(keys[0] == keys[1]);
    std::sort(keys.begin(), keys.end());
    CHECK(std::unique(keys.begin(), keys.end()) - keys.begin() >= 4);
  }
  CHECK(arranged("0 0 " + p + " 3  0 0 " + p2 + " 6").substr(0, 7) == "V 3 E 2");
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
