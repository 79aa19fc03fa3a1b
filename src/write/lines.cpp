// LAR's .lines: a row "x1,y1,x2,y2" per segment.

#include "plumbline/write.hpp"

namespace plumbline {

std::string to_lines(std::span<const lar::SegmentD> segments) {
  std::string rows;
  for (const auto& [a, b] : segments) {
    for (const double coordinate : {a.x, a.y, b.x, b.y}) {
      rows += shortest_text(coordinate) + ',';
    }
    rows.back() = '\n';
  }
  return rows;
}

}  // namespace plumbline
