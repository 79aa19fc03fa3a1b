// The numbers of the bucket engine: grids, exact integers, the double filter, keys.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "arrange/bucket/filtered_kernel.hpp"
#include "arrange/bucket/grid_kernel.hpp"
#include "arrange/bucket/weighted_input.hpp"
#include "geometry/stored.hpp"
#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

bucket::Job serial() { return bucket::Job(1, {}); }

std::string kernel_of(const std::string& text) {
  bucket::Job job = serial();
  const auto grid = bucket::GridInput::from(segments(text), job);
  if (!grid) return "weighted";
  return bucket::GridKernel::fits(*grid) ? "narrow" : "wide";
}

}  // namespace

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
      CHECK(lowest(kernel.point(bucket::first_end(line))) == std::min(drawn[s].a, drawn[s].b));
      CHECK(lowest(kernel.point(bucket::last_end(line))) == std::max(drawn[s].a, drawn[s].b));
    }
    CHECK(lowest(kernel.crossing(0, 2)) == lowest(bucket::FilteredKernel(set, job).crossing(0, 2)));
  }
}

TEST_CASE("a drawing of 31 bits is narrow wherever it lies") {
  CHECK(kernel_of("10000000000000000000 5 10000000000000000001 6") == "narrow");
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
    std::vector<bucket::ExactLines<bucket::Words>::Line> words;
    for (const auto& line : grid.lines) {
      const mpz_class weight(static_cast<int>(lines.size() % 3 + 1));
      lines.emplace_back();
      words.emplace_back();
      for (std::size_t k = 0; k < line.size(); ++k) {
        lines.back()[k] = bucket::to_mpz(line[k]) * weight;
      }
      lines.back()[4] = weight;
      for (std::size_t k = 0; k < 5; ++k) {
        words.back()[k] = bucket::Words(lines.back()[k].get_mpz_t());
      }
    }
    wide = {grid.lines, grid.frame};
    weighted = {lines, grid.frame};
    short_weighted = {words, grid.frame};
  }
  bucket::ExactLines<bucket::Int128> wide;
  bucket::ExactLines<mpz_class> weighted;
  bucket::ExactLines<bucket::Words> short_weighted;
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
  CHECK(decisions(Sides(exact.short_weighted)) == expected);
  CHECK(decisions(bucket::FilteredKernel(*grid, job)) == expected);
  CHECK(decisions(bucket::FilteredKernel(input, job)) == expected);
  if (bucket::GridKernel::fits(*grid)) CHECK(decisions(bucket::GridKernel(*grid)) == expected);
  CHECK(arrange(input) == arrange(input, ExactEngine::Cgal));
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
    CHECK(decisions(Sides(exact.short_weighted)) == expected);
  }
}

TEST_CASE("fractions of 255 bits are decided and located like those of any size") {
  using bucket::Words;
  const mpz_class most = (mpz_class(1) << 255) - 1, least = -most;
  // Two weights; a long slanted line, one that crosses it, and points a hair off both.
  const std::vector<std::array<mpz_class, 5>> numbers{{least, least, most, most - 1, most},
                                                      {least, most, most, least + 1, most - 1},
                                                      {0, 0, most, 1 - most, most - 1},
                                                      {least + 1, least, 1, 0, most},
                                                      {0, 0, 1, 1, 1}};
  std::vector<bucket::ExactLines<mpz_class>::Line> lines;
  std::vector<bucket::ExactLines<Words>::Line> words;
  for (const auto& line : numbers) {
    lines.push_back(line);
    words.emplace_back();
    for (std::size_t k = 0; k < 5; ++k) words.back()[k] = Words(line[k].get_mpz_t());
  }
  const Sides any(bucket::ExactLines<mpz_class>(lines, {}));
  const Sides fixed(bucket::ExactLines<Words>(words, {}));
  CHECK(decisions(fixed) == decisions(any));
  CHECK(decisions(Sides(bucket::of_any_size(fixed))) == decisions(any));
  CHECK(lowest(fixed.crossing(0, 1)) == lowest(any.crossing(0, 1)));
  CHECK(lowest(fixed.point(3)) == lowest(any.point(3)));
  CHECK(fixed.can_join(0, 7));
  CHECK_FALSE(fixed.can_join(0, 2));
  CHECK(fixed.can_join(8, 9));
}

TEST_CASE("segments that overlap are joined though the fractions of the whole are too long") {
  // On the line from (0, 0) to (3, 1), with denominators of 200 bits that have nothing in common.
  const auto fraction = [](unsigned long base, unsigned long power, unsigned long numerator) {
    mpz_class d;
    mpz_ui_pow_ui(d.get_mpz_t(), base, power);
    return Rational(numerator * (d / 8) + 1, d);
  };
  const std::vector<Rational> at{fraction(3, 126, 1), fraction(5, 86, 3), fraction(7, 71, 2),
                                 fraction(11, 58, 5)};
  SegmentSet input;
  const SourceId source = input.add_source({});
  const auto add = [&](const Rational& from, const Rational& to) {
    input.add(Segment{{3 * from, from}, {3 * to, to}}, source);
  };
  add(at[0], at[1]);
  add(at[2], at[3]);
  input.add(Segment{{1, 1}, {Rational(4, 5), -1}}, source);
  CHECK(arrange(input) == arrange(input, ExactEngine::Cgal));
  CHECK(arrange(input).edges.size() == 6);
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

TEST_CASE(
    "lines share an end where it is the same point, not where it rounds to the same doubles") {
  // Ends of the second and the third line round to one end of the first.
  const SegmentSet input =
      segments("0 0 1/3 2  1/3 2 5 1  0.33333333333333333333 2 5 4  1 7 1/3 2  0 0 1 7  0 3 1 3");
  bucket::Job job = serial();
  const bucket::FilteredKernel kernel(input, job);
  const auto shared = [](const auto& lines, bucket::LineId s) {
    std::string text;
    for (bucket::LineId o = 0; o < lines.size(); ++o) text += lines.share_end(s, o) ? '1' : '0';
    return text;
  };
  CHECK(shared(kernel, 0) == "110110");
  CHECK(shared(kernel, 2) == "001000");
  const SegmentSet narrow = segments("0 0 1 2  1 2 5 1  1 3 5 2  1 7 1 2  0 0 1 7  2 2 1 3");
  CHECK(shared(bucket::GridKernel(*bucket::GridInput::from(narrow, job)), 0) == "110110");
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
  const SegmentSet overlap = segments("0 0 " + p + " 3  0 0 " + p2 + " 6");
  CHECK(summary(arrange(overlap)).substr(0, 7) == "V 3 E 2");
}

TEST_CASE("integers of a fixed size are added, multiplied and compared as GMP does") {
  std::mt19937_64 random(4);
  const auto integer = [&] {  // of any length, often next to a power of two
    const mpz_class one = 1, v = one << (random() % 250);
    const mpz_class below =
        random() % 2 == 0 ? mpz_class(v - 1) : mpz_class(v / (1 + random() % 9));
    return random() % 2 == 0 ? below : mpz_class(-below);
  };
  using Short = FixedInteger<4>;
  for (int i = 0; i < 20000; ++i) {
    const mpz_class m = integer(), n = random() % 10 == 0 ? m : integer();
    const Short a(m.get_mpz_t()), b(n.get_mpz_t());
    REQUIRE(to_mpz(a) == m);
    REQUIRE(to_mpz(a + b) == m + n);
    REQUIRE(to_mpz(a - b) == m - n);
    REQUIRE(to_mpz(-a) == -m);
    REQUIRE(to_mpz(product(a, b)) == m * n);
    REQUIRE((a < b) == (m < n));
    REQUIRE((a > b) == (m > n));
    REQUIRE((a == b) == (m == n));
    REQUIRE(sign(a) == sgn(m));
    REQUIRE(a.bits() == (m == 0 ? 0 : static_cast<int>(mpz_sizeinbase(m.get_mpz_t(), 2))));
    REQUIRE(compare_products(a, a, b, b) == bucket::sign(cmp(m * m, n * n)));
    const auto low = static_cast<bucket::Int128>(random()) * static_cast<std::int64_t>(random());
    REQUIRE(to_mpz(FixedInteger<2>(low)) == bucket::to_mpz(low));
  }
}
