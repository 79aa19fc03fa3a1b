#pragma once

#include <cstdint>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::features {

/// An edge between two points. Edges of one kind may be joined.
struct ChainEdge {
  std::uint32_t a, b;
  std::uint32_t kind = 0;
};

/// Edges joined to chains: each edge is in one chain.
struct Chains {
  Lists<std::uint32_t> points;  ///< of each chain; of a closed one the first again at the end
  std::vector<std::uint32_t> chain_of;  ///< per edge
  std::vector<bool> runs_against;       ///< per edge whether the chain goes from b to a
};

/// The chains of edges, as long as can be, that end at nodes: where not just two edges meet, or two
/// of different kinds, or `is_node` says so. Requires: a != b. Order: by
/// the first edge of each, which it follows from a to b; a closed one begins there where it has no
/// node. Cost: linear.
Chains chains(const std::vector<ChainEdge>& edges, const std::vector<bool>& is_node);

}  // namespace plumbline::features
