#pragma once

#include <utility>
#include <vector>

#include "compare/sides.hpp"

namespace plumbline::compare_steps {

/// Cells of both sides that correspond, directly or through others.
using Group = Both<std::vector<std::size_t>>;

/// The connected components of a relation between cells of the two sides (pairs of an exact and a
/// float cell) over the given cells, which are listed ascending. Order: by their least exact cell,
/// those without one last, by their least float cell.
std::vector<Group> connected_groups(
    const Both<std::vector<std::size_t>>& cells,
    const std::vector<std::pair<std::size_t, std::size_t>>& relation);

}  // namespace plumbline::compare_steps
