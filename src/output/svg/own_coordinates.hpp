#pragma once

#include <string>

#include "output/svg/kit.hpp"

namespace plumbline::svg {

/// A picture in the drawing's own coordinates: the numbers of its paths are relative to an origin
/// near the drawing, where that is far from (0, 0), and times a power of two that makes the
/// picture 500 to 2000 wide or high, for viewers that compute with few digits. A transform of a
/// group undoes both, exactly: near (0, 0) one that viewers apply, else one that our reader does
/// and a `desc` tells of.
struct OwnCoordinates {
  Frame frame;        ///< for the numbers in the group
  Box box;            ///< of the drawing, as the numbers in the group have it
  double unit;        ///< a thousandth of the picture, in them
  std::string about;  ///< what is to be said of the picture, for people; "" for nothing
};
OwnCoordinates own_coordinates(const Extent& extent, bool y_up);

/// From the root to the beginning of the group; `foot` is the height of what stands below.
std::string open(const OwnCoordinates& picture, double foot);
inline constexpr const char* kClose = "</g>\n</svg>\n";
/// Attributes of lines that are as wide at every zoom.
inline constexpr const char* kNonScaling = " vector-effect=\"non-scaling-stroke\"";

}  // namespace plumbline::svg
