#pragma once

#include <cstdint>

#include "plumbline/error.hpp"

namespace plumbline {

/// What a ring bounds.
enum class RingRole : std::uint8_t {
  Polygon,  ///< a polygon, or the first part of a polygon of several parts, from outside
  Part,     ///< a further part of that polygon, from outside
  Hole,     ///< a hole of the polygon or part before it
  Line,     ///< a closed line that is no part of a polygon
};

/// "polygon", "part", "hole", "line".
constexpr const char* to_text(RingRole role) {
  switch (role) {
    case RingRole::Polygon:
      return "polygon";
    case RingRole::Part:
      return "part";
    case RingRole::Hole:
      return "hole";
    case RingRole::Line:
      break;
  }
  return "line";
}

/// Segments of which each starts where the one before it ends. Only a ring that the drawing does
/// not close ends elsewhere than it starts.
struct Ring {
  std::uint32_t first = 0, count = 0;  ///< its segments; none where all had no length
  RingRole role = RingRole::Polygon;

  friend bool operator==(const Ring&, const Ring&) = default;
};

}  // namespace plumbline
