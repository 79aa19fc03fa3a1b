#pragma once

#include <span>

#include "output/json/values.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::json {

/// The array of signed edges counted from 1: k runs along edge k - 1, -k against it.
inline auto signed_edges(std::span<const HalfedgeId> halfedges) {
  return list(halfedges, [](HalfedgeId h) {
    const auto number = static_cast<std::int64_t>(std::size_t{edge_of(h)}) + 1;
    return is_reversed(h) ? -number : number;
  });
}

}  // namespace plumbline::json
