#pragma once

#include "compare/overlay.hpp"

namespace plumbline::compare_steps {

/// The same regions as `overlay` of two valid complexes, but that those of the same faces are one.
/// **Exact**. No arrangement is made: the area that two faces have in common is the sum along what
/// runs around it, which are the pieces of the boundary of each that lie inside the other one, and
/// the pieces that both have. Requires: both sides are valid; bounded faces. Cost: that of
/// `contacts`, and of `locate_all` for what meets nothing of the other side.
std::vector<Region> face_overlaps(const Sides& sides, const Both<std::vector<std::size_t>>& faces);

}  // namespace plumbline::compare_steps
