#pragma once

#include <span>
#include <vector>

#include "plumbline/engines/inters.hpp"

namespace plumbline::inters {

/// The vertices of a cycle of edges, in the order of a set of numbers.
std::vector<VertexId> cycle_vertices(std::span<const VertexPair> edges);

}  // namespace plumbline::inters
