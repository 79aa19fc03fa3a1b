#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

namespace plumbline {

/// The value of a property in a style attribute, without blanks and "!important"; empty where there
/// is none. The last declaration counts.
std::string_view style_property(std::string_view style, std::string_view name);

/// The value of a property: of the element's style or else of its attribute of that name.
std::string_view presentation(const pugi::xml_node& element, const char* name);

/// Whether the element and all below it are drawn: its property `display` is not `none`.
bool is_displayed(const pugi::xml_node& element);

/// Whether the element's own property `visibility` shows it; nothing where it inherits.
std::optional<bool> own_visibility(const pugi::xml_node& element);

/// Throws: Unusable where something other than the attributes that are read places the element: a
/// property of its style, or a transform-origin.
void check_placement(const pugi::xml_node& element, std::string_view name);

}  // namespace plumbline
