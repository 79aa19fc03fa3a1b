#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "read/attribute.hpp"

namespace plumbline {

/// What percentages refer to: the extents of the nearest viewport, in the user units inside it.
/// Nothing where the drawing leaves them open.
struct SvgViewport {
  std::optional<Rational> width, height;

  friend bool operator==(const SvgViewport&, const SvgViewport&) = default;
};

/// A length in user units: a number, bare or with px, in, cm, mm, Q, pt or pc, an inch being 96 px;
/// or a percentage of `whole`. **Exact**. Throws: Unusable for anything else, and for a percentage
/// of nothing. Source: SVG 1.1, 7.10; CSS Values 3, 6.2.
Number parse_length(std::string_view text, const std::optional<Rational>& whole, Numbers& numbers);

/// Whether the text is a length in in, cm, mm, Q, pt or pc.
bool is_physical_length(std::string_view text);
/// So many 1/96 inches as a unit: "mm", "cm", ... where it is one of them, else "user unit".
LengthUnit svg_unit(const Rational& user_units);

/// The length in an attribute, 0 where it is missing. Throws: Unusable, naming the attribute.
Number length_attribute(const pugi::xml_node& element, const char* name,
                        const std::optional<Rational>& whole, Numbers& numbers);

/// An attribute as a problem quotes it: name="value".
std::string quoted(const char* name, std::string_view value);

}  // namespace plumbline
