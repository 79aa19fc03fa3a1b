// LAR's .lines: a row "x1,y1,x2,y2" per segment.

#include <algorithm>
#include <array>

#include "plumbline/output.hpp"

namespace plumbline {

std::string to_lines(std::span<const SegmentD> segments) {
  std::string rows;
  for (const auto& [a, b] : segments) {
    for (const double coordinate : {a.x, a.y, b.x, b.y}) {
      rows += shortest_text(coordinate) + ',';
    }
    rows.back() = '\n';
  }
  return rows;
}

std::string to_lines(const SegmentSet& input) {
  std::string rows;
  const auto add = [&](std::span<const Number> coordinates) {
    for (const Number& coordinate : coordinates) rows += exact_text(coordinate.rational()) + ',';
    rows.back() = '\n';
  };
  for (std::size_t s = 0; s < input.segments.size(); ++s) add(input.segments.numbers(s));
  for (const Point& p : input.points) add(std::array{Number(p.x), Number(p.y)});
  return rows;
}

bool are_decimals(const ExactComplex& complex) {
  const auto is_decimal = [](const Rational& x) {
    mpz_class rest;
    for (const unsigned prime : {2U, 5U}) {
      mpz_remove(rest.get_mpz_t(), (prime == 2 ? x.get_den() : rest).get_mpz_t(),
                 mpz_class(prime).get_mpz_t());
    }
    return rest == 1;
  };
  return std::ranges::all_of(complex.vertices,
                             [&](const Point& p) { return is_decimal(p.x) && is_decimal(p.y); });
}

std::string to_lines(const ExactComplex& complex) {
  std::string rows;
  for (const auto& [tail, head] : complex.edges) {
    for (const VertexId v : {tail, head}) {
      const Point p = complex.vertices[v];
      rows += decimal_text(p.x) + ',' + decimal_text(p.y) + ',';
    }
    rows.back() = '\n';
  }
  return rows;
}

}  // namespace plumbline
