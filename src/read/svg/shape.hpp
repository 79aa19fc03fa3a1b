#pragma once

#include <pugixml.hpp>

#include "read/svg/length.hpp"
#include "read/svg/path.hpp"

namespace plumbline {

/// What shapes are read with.
struct SvgTools {
  Numbers& numbers;
  Flattener& flattener;
  double bound;  ///< on what replaces a number that is not rational
};

/// The pieces of a `line`, `rect`, `circle`, `ellipse`, `polyline`, `polygon` or `path`, in the
/// element's coordinates. **Exact** but for what they list as replaced. Degenerate: a shape that
/// draws nothing is refused as a whole; zero-length pieces are kept. Throws: Unusable where the
/// element as a whole can't be used. Source: SVG 1.1, 9.
Pieces parse_shape(const pugi::xml_node& element, std::string_view name,
                   const SvgViewport& viewport, const SvgTools& tools);

}  // namespace plumbline
