#pragma once

#include <string>
#include <vector>

#include "inputs/draw.hpp"
#include "plumbline/geometry.hpp"

/// Families of small random inputs that hurt an arrangement. Each input is determined by its
/// family, seed and extent.
namespace plumbline::inputs {

/// Their names: what each is built to hurt.
const std::vector<std::string>& families();
/// What a small input of a family costs to arrange.
enum class Cost {
  Cheap,
  Dear,  ///< about twice as much: its numbers are long or its segments more
  /// Has no small inputs, since it puts more into a place than a bucket tests by pairs, or has
  /// curves.
  FullPlace,
};
/// Throws: std::out_of_range for another name; `of_family` as well.
Cost cost(const std::string& family);

/// An input of some ten segments, small ones of some five, in the families of full places some
/// thirty to 300.
SegmentSet of_family(const std::string& family, unsigned seed, Extent extent = Extent::Usual);

}  // namespace plumbline::inputs
