#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace plumbline {

/// What the reader does with an element.
enum class SvgKind {
  Container,  ///< g, a, svg, use
  Shape,      ///< line, rect, circle, ellipse, polyline, polygon, path
  Text,       ///< text: a label
  Undrawn,  ///< never drawn in its place: defs, clipPath, title, another vocabulary's element, ...
  Unknown,  ///< drawn, but not understood yet
};

/// By the local name of an element of the SVG namespace.
SvgKind svg_kind(std::string_view local_name);

/// The name without its namespace prefix.
std::string_view local_name(const pugi::xml_node& element);

/// The element's transform; of a picture that this program drew at a local origin, the way back.
pugi::xml_attribute map_attribute(const pugi::xml_node& element);
/// Whether an element below `top`, or `top` itself, is by its name one that draws.
bool holds_drawing(const pugi::xml_node& top);
/// How many of them there are.
std::size_t count_drawn(const pugi::xml_node& top);
/// The same for what has lines: shapes, and uses of them.
bool holds_shape(const pugi::xml_node& top);

/// The namespace prefixes in force on the way down a document.
class Namespaces {
 public:
  /// Takes in the declarations of an element, takes back those of the last one entered.
  void enter(const pugi::xml_node& element);
  void leave();
  /// Whether the element, which was entered, is SVG's. A document that declares no namespace at all
  /// counts as SVG.
  bool is_svg(const pugi::xml_node& element) const;

 private:
  std::unordered_map<std::string, std::vector<std::string>> uris_;  ///< per prefix, innermost last
  std::vector<std::string> declared_;  ///< the prefixes, in the order of their declarations
  std::vector<std::size_t> entered_;   ///< of declared_, before each element that is open
};

}  // namespace plumbline
