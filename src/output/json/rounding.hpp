#pragma once

#include <span>

#include "output/json/writer.hpp"
#include "plumbline/round.hpp"

namespace plumbline {

/// The array of signed edges counted from 1: k runs along edge k - 1, -k against it.
void write_signed_edges(JsonWriter& json, std::span<const HalfedgeId> halfedges);

/// The member "rounding", written into the open object. Documented in docs/json.md.
void write_rounding(JsonWriter& json, const ExactComplex& exact, const Grid& grid,
                    const Rounding& rounding);

}  // namespace plumbline
