#pragma once

#include <string>

#include "plumbline/structure.hpp"
#include "read/dxf/entity.hpp"

namespace plumbline::dxf {

/// A reference to a block: an array of copies of it.
struct Insert {
  std::string block;  ///< key of its name
  Affine place;       ///< of the array, after its rotation; mirrored for Plane::Back
  Struct::Item turn;  ///< of the array, an Affine or a Turn
  Affine scale;       ///< of the block about its base point
  std::size_t columns = 1, rows = 1;
  Rational column_distance, row_distance;  ///< before rotation
};

/// Most copies that an array may have.
inline constexpr std::size_t kMaxCopies = 1'000'000;

/// An INSERT record, without its block. A direction in which copies are 0 apart has one. Throws:
/// Unusable.
Insert insert_of(const Entity& entity, std::string block, const Source& source);

}  // namespace plumbline::dxf
