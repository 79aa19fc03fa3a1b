#pragma once

#include <pugixml.hpp>

#include "read/svg_path.hpp"

namespace plumbline {

/// The pieces of a `line`, `rect`, `polyline`, `polygon` or `path`, in the element's coordinates.
/// **Exact**. Degenerate: a shape that draws nothing is refused as a whole; zero-length pieces are
/// kept. Throws: Unusable where the element as a whole can't be used. Source: SVG 1.1, 9.
Pieces parse_shape(const pugi::xml_node& element, std::string_view name, Numbers& numbers);

/// The length in an attribute, 0 where it is missing. Throws: Unusable, naming the
/// attribute.
Number length_attribute(const pugi::xml_node& element, const char* name, Numbers& numbers);

}  // namespace plumbline
