#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

#include "plumbline/structure/model.hpp"
#include "read/svg/length.hpp"

namespace plumbline {

/// What a shape is called: its `title`, else its inkscape:label, else its id if a person may have
/// given it. Empty where nothing names it.
std::string shape_name(const pugi::xml_node& shape);

/// Whether an id is one that programs make: a word such as "path", "rect", "svg" or "XMLID", or
/// nothing, then digits and separators alone ("path3456-7", "svg_12", "_12"); one that begins with
/// "_x"; 16 characters or more of hexadecimal digits and hyphens.
bool is_generated_id(std::string_view id);

/// What a `text` says, blanks single, at its x and y or those of the first `tspan` that has them.
/// None for an empty text. Throws: Unusable for a text on a path, and where x or y is no length.
std::optional<Model::Text> text_of(const pugi::xml_node& text, const SvgViewport& viewport,
                                   Numbers& numbers);

}  // namespace plumbline
