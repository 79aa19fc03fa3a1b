#pragma once

#include <vector>

#include "plumbline/engine/cell_lists.hpp"

namespace plumbline::files {

/// Puts the vertices into rings that pass them by: where one ring goes straight from a to b and
/// other rings, by sides that are theirs alone, through further vertices in line. Such rings
/// enclose the same area, and differ in nothing else. What is in line is so up to kInLine of the
/// extent. Returns those vertices, ascending. Cost: O(n log n), and the sides at each vertex that
/// is passed.
std::vector<VertexId> split_rings(CellLists& cells);
inline constexpr double kInLine = 1e-9;  ///< as `kToleranceOfAnswers`

}  // namespace plumbline::files
