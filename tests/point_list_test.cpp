#include "plumbline/geometry/point_list.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "geometry/stored.hpp"
#include "number/wide.hpp"

using namespace plumbline;

namespace {

/// Numbers of very different sizes: integers, decimals, fractions, and what 126 bits do not hold.
Rational number(std::mt19937_64& random) {
  const auto bits = [&](unsigned count) {
    mpz_class value = 0;
    for (unsigned i = 0; i < count; i += 32) {
      value = (value << 32) + static_cast<unsigned long>(random() & 0xffffffffU);
    }
    return mpz_class(value >> (random() % 32));
  };
  static constexpr unsigned kSizes[] = {32, 32, 64, 96, 128, 160, 2000};
  Rational result = bits(kSizes[random() % 7]);
  switch (random() % 4) {
    case 0:
      break;
    case 1:
      result /= static_cast<long>(wide::kPowersOfTen[random() % 19]);
      break;
    case 2:
      result /= mpz_class(1) << (random() % 140);
      break;
    default:
      result /= bits(kSizes[random() % 7]) + 1;
  }
  return random() % 2 == 0 ? result : Rational(-result);
}

std::vector<Point> some_points(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({number(random), number(random)});
    if (i % 3 == 0) points.push_back({points.back().x, number(random)});
    if (i % 10 == 0) points.push_back(points.front());
  }
  return points;
}

}  // namespace

TEST_CASE("a list gives back the points that it was given, however it stores them") {
  const std::vector<Point> points = some_points(3000);
  const PointList list{std::span<const Point>(points)};
  REQUIRE(list.size() == points.size());
  std::size_t wide = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(list[i] == points[i]);
    REQUIRE(list.nearest(i) == nearest(points[i]));
    REQUIRE(list.truncated(i) == PointD{points[i].x.get_d(), points[i].y.get_d()});
    wide += list.wide(i) != nullptr ? 1 : 0;
  }
  CHECK(wide > points.size() / 10);
  CHECK(wide < points.size());
  CHECK(std::equal(list.begin(), list.end(), points.begin()));
  CHECK_THROWS_AS(list.at(points.size()), std::out_of_range);
}

TEST_CASE("points of a list compare as the points that they are") {
  std::vector<Point> points = some_points(60);
  const PointList list{std::span<const Point>(points)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      const int expected = points[i] < points[j] ? -1 : (points[j] < points[i] ? 1 : 0);
      REQUIRE(list.compare(i, j) == expected);
    }
  }
  std::sort(points.begin(), points.end());
  const PointList sorted{std::span<const Point>(points)};
  for (const Point& p : some_points(80)) {
    const auto first = std::lower_bound(points.begin(), points.end(), p);
    CHECK(sorted.count_before(p) == static_cast<std::size_t>(first - points.begin()));
  }
}

TEST_CASE("equal lists are equal in whatever terms their points are") {
  const PointList lowest{{Rational(1, 2), 3}, {Rational(1, 3), Rational(1, 6)}};
  const auto wide = [](std::vector<WidePoint> points) { return PointList(std::move(points)); };
  CHECK(wide({{2, 12, 4}, {4, 2, 12}}) == lowest);
  CHECK_FALSE(wide({{2, 12, 4}, {4, 3, 12}}) == lowest);
  CHECK_FALSE(wide({{2, 12, 4}}) == lowest);
}

TEST_CASE("points in integers of any size are read as they are in lowest terms") {
  std::vector<Point> points = some_points(300);
  std::vector<LongPoint> unreduced;
  for (const Point& p : points) {
    const mpz_class k = mpz_class(12) << (unreduced.size() % 300);
    unreduced.push_back({p.x.get_num() * p.y.get_den() * k, p.y.get_num() * p.x.get_den() * k,
                         p.x.get_den() * p.y.get_den() * k});
  }
  const PointList list(unreduced), expected{std::span<const Point>(points)};
  REQUIRE(list == expected);
  std::size_t wide = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(list[i] == points[i]);
    REQUIRE(list.nearest(i) == expected.nearest(i));
    REQUIRE(list.truncated(i) == expected.truncated(i));
    const std::size_t j = (i + 1) % points.size();
    REQUIRE(list.compare(i, j) == expected.compare(i, j));
    wide += list.wide(i) != nullptr ? 1 : 0;
  }
  CHECK(wide > 0);
  CHECK(wide < points.size() / 2);
}

TEST_CASE("points are replaced and brought into another order") {
  std::vector<Point> points = some_points(50);
  PointList list{std::span<const Point>(points)};
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    list.replace(i, points[i + 1]);
    points[i] = points[i + 1];
  }
  std::vector<std::size_t> order;
  std::vector<Point> reversed(points.rbegin(), points.rend());
  for (std::size_t i = points.size(); i-- > 0;) order.push_back(i);
  list.reorder(order);
  CHECK(list == PointList(std::span<const Point>(reversed)));
}

TEST_CASE("points lie at stored ends and on the lines of stored segments as exactly as they can") {
  std::mt19937_64 random(3);
  for (int round = 0; round < 3000; ++round) {
    const Point a{number(random), number(random)}, b{number(random), number(random)};
    const Rational t(static_cast<long>(random() % 1000), 1 + random() % 1000);
    const Point on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const Point off{on.x + Rational(1, mpz_class(1) << (random() % 200)), on.y};
    const PointList list{a, b, on, off};
    const std::array<Number, 4> segment{a.x, a.y, b.x, b.y};
    for (std::size_t i = 0; i < list.size(); ++i) {
      REQUIRE(is_on_line(list, i, segment) == (orientation(a, b, list[i]) == 0));
      REQUIRE(is_at(list, i, segment[0], segment[1]) == (list[i] == a));
    }
  }
}

TEST_CASE(
    "fractions of 128 bits are written, rounded and compared as the rationals that they are") {
  std::mt19937_64 random(11);
  std::size_t written = 0;
  for (int round = 0; round < 20000; ++round) {
    const Rational value = number(random);
    const auto fraction = wide::fraction(value);
    if (!fraction) continue;
    REQUIRE(wide::quotient(fraction->n, fraction->d) == value);
    for (const int base : {10, 16}) {
      std::string text;
      wide::append_fraction(text, *fraction, base);
      REQUIRE(text == value.get_str(base));
    }
    ++written;
    REQUIRE(parse_decimal(exact_text(value)) == value);
    if (abs(value.get_num()) >= mpz_class(1) << 126 || value.get_den() >= mpz_class(1) << 126) {
      continue;
    }
    REQUIRE(wide::nearest_quotient(fraction->n, fraction->d) == nearest_double(value));
  }
  CHECK(written > 1000);
  CHECK(wide::nearest_quotient((wide::Int128{1} << 53) + 1, 1) == 0x1p53);  // ties to even
  CHECK(wide::nearest_quotient((wide::Int128{1} << 53) + 3, 1) == 0x1p53 + 4);
  CHECK(wide::nearest_quotient(-1, 3) == -1.0 / 3);
  CHECK(wide::truncated_quotient((wide::Int128{1} << 54) - 1, 1) == 0x1p54 - 2);
  CHECK(wide::truncated_quotient(-7, 2) == -3.5);
}

TEST_CASE("greatest common divisors of 128 bits are those of GMP") {
  std::mt19937_64 random(5);
  const auto integer = [&] {
    const auto high = static_cast<wide::UInt128>(random()) << 64;
    return (high | random()) >> (random() % 128);
  };
  for (int round = 0; round < 5000; ++round) {
    const wide::UInt128 common = integer() >> 64, a = common * (integer() >> 64),
                        b = common * (integer() >> 64);
    const wide::UInt128 divisor = wide::gcd(a, b);
    if (a == 0 || b == 0) {
      CHECK(divisor == (a | b));
      continue;
    }
    REQUIRE((a % divisor == 0 && b % divisor == 0));
    REQUIRE(wide::gcd(a / divisor, b / divisor) == 1);
  }
}
