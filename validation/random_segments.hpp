#pragma once

#include <string>
#include <vector>

#include "plumbline/geometry.hpp"

/// Families of small random inputs that hurt an arrangement. Each input is determined by its family
/// and seed.
namespace random_segments {

/// Their names: what each is built to hurt.
const std::vector<std::string>& families();

/// An input of some ten segments, in the families of full places some thirty to 300. Requires: one
/// of the families; throws std::out_of_range.
plumbline::SegmentSet make(const std::string& family, unsigned seed);

}  // namespace random_segments
