#pragma once

#include <optional>
#include <pugixml.hpp>

#include "plumbline/structure.hpp"
#include "read/attribute.hpp"
#include "read/svg/length.hpp"

namespace plumbline {

/// Where a nested `svg` or a `symbol` stands.
struct SvgPlacement {
  Affine map;          ///< from the user units inside it to those around it
  SvgViewport inside;  ///< what percentages inside it refer to
  bool clips = false;  ///< whether it hides what lies outside its viewport
};

/// The extents that a `use` gives what it refers to, as the texts of its attributes; empty where it
/// has none.
struct SvgExtents {
  std::string_view width, height;
};

/// The user space of the root: its viewBox, or else its width and height.
SvgViewport root_viewport(const pugi::xml_node& root, Numbers& numbers);

/// What a user unit of the root is, where its width or height is in mm, cm, Q, in, pt or pc:
/// 1/96 inch, or what the viewBox makes of it. **Exact**. None where
/// it is not the same in both directions, and for malformed attributes.
std::optional<LengthUnit> root_unit(const pugi::xml_node& root, Numbers& numbers);

/// Places an `svg` or `symbol` by its x, y, width, height, viewBox and preserveAspectRatio.
/// **Exact**. Throws: Unusable for what is malformed, negative or has no extent, and for a scale
/// that depends on an unknown extent. Source: SVG 1.1, 7.7 to 7.9; SVG 2, 8.2.
SvgPlacement place_viewport(const pugi::xml_node& element, const SvgExtents& given,
                            const SvgViewport& around, Numbers& numbers);

}  // namespace plumbline
