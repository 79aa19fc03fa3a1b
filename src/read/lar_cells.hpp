#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline {

/// Cells as lists of vertex indices, each with its place.
struct LarCells {
  struct Cell {
    std::size_t end;  ///< in `vertices`
    std::uint32_t line, column;
  };
  std::vector<std::uint32_t> vertices;
  std::vector<Cell> cells;

  std::span<const std::uint32_t> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : cells[i - 1].end;
    return std::span(vertices).subspan(begin, cells[i].end - begin);
  }
};

}  // namespace plumbline
