#pragma once

#include "plumbline/engine.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {

/// The pieces as a graph over their distinct ends, each piece once; isolated points last.
Graph graph_of(const LineWork& work);

/// The complex of pieces that are not cut any more: their arrangement where they meet in common
/// ends only, else the cells of the graph as it is, which may be invalid (edges cross).
ExactComplex cells_of(const LineWork& work, std::size_t threads);

/// Whether the pieces, equal ones once, meet in common ends only.
bool is_plane(const LineWork& work, std::size_t threads);

}  // namespace plumbline::lar
