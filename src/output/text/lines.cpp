// LAR's .lines: a row "x1,y1,x2,y2" per segment.

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
