#include "read/svg/element.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "read/xml.hpp"

namespace plumbline {
namespace {

using Names = std::string_view;

constexpr Names kSvgNamespace = "http://www.w3.org/2000/svg";
constexpr std::array<Names, 4> kContainers{"g", "a", "svg", "use"};
constexpr std::array<Names, 7> kShapes{"line",     "rect",    "circle", "ellipse",
                                       "polyline", "polygon", "path"};
constexpr std::array<Names, 4> kOtherDrawn{"use", "text", "image", "foreignObject"};
// clang-format off
constexpr std::array<Names, 31> kUndrawn{
    "defs", "symbol", "clipPath", "mask", "pattern", "marker", "linearGradient", "radialGradient",
    "meshgradient", "hatch", "solidcolor", "filter", "title", "desc", "metadata", "style", "script",
    "color-profile", "cursor", "font", "font-face", "glyph", "missing-glyph", "view", "animate",
    "animateColor", "animateMotion", "animateTransform", "set", "mpath", "discard"};
// clang-format on

template <class Array>
bool contains(const Array& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? std::string_view() : name.substr(0, colon);
}

/// The prefix that an attribute declares ("" for the default namespace), if it is a declaration.
const char* declared_prefix(const pugi::xml_attribute& attribute) {
  constexpr std::string_view kXmlns = "xmlns";
  const char* const name = attribute.name();
  if (*name != 'x' || std::strncmp(name, kXmlns.data(), kXmlns.size()) != 0) return nullptr;
  const char* const rest = name + kXmlns.size();
  if (*rest == '\0') return "";
  return *rest == ':' ? rest + 1 : nullptr;
}

bool is_drawn(const pugi::xml_node& element) {
  const std::string_view name = local_name(element);
  return contains(kShapes, name) || contains(kOtherDrawn, name);
}

}  // namespace

SvgKind svg_kind(std::string_view local_name) {
  if (contains(kShapes, local_name)) return SvgKind::Shape;
  if (local_name == "text") return SvgKind::Text;
  if (contains(kContainers, local_name)) return SvgKind::Container;
  return contains(kUndrawn, local_name) ? SvgKind::Undrawn : SvgKind::Unknown;
}

std::string_view local_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

pugi::xml_attribute map_attribute(const pugi::xml_node& element) {
  const pugi::xml_attribute of_picture = element.attribute("data-plumbline-transform");
  return of_picture ? of_picture : element.attribute("transform");
}

bool holds_drawing(const pugi::xml_node& top) {
  for (auto node = top; node; node = next_below(top, node)) {
    if (is_drawn(node)) return true;
  }
  return false;
}

std::size_t count_drawn(const pugi::xml_node& top) {
  std::size_t count = 0;
  for (auto node = top; node; node = next_below(top, node)) count += is_drawn(node) ? 1 : 0;
  return count;
}

bool holds_shape(const pugi::xml_node& top) {
  if (local_name(top) == "flowRoot") return false;  // its shapes frame a text
  for (auto node = top; node; node = next_below(top, node)) {
    const std::string_view name = local_name(node);
    if (contains(kShapes, name) || name == "use") return true;
  }
  return false;
}

void Namespaces::enter(const pugi::xml_node& element) {
  entered_.push_back(declared_.size());
  for (auto a = element.first_attribute(); a; a = a.next_attribute()) {
    const char* const name = declared_prefix(a);
    if (name == nullptr) continue;
    uris_[name].emplace_back(a.value());
    declared_.emplace_back(name);
  }
}

void Namespaces::leave() {
  for (; declared_.size() > entered_.back(); declared_.pop_back()) {
    uris_[declared_.back()].pop_back();
  }
  entered_.pop_back();
}

bool Namespaces::is_svg(const pugi::xml_node& element) const {
  const std::string name(prefix(element.name()));
  const auto found = uris_.find(name);
  if (found != uris_.end() && !found->second.empty()) return found->second.back() == kSvgNamespace;
  return name.empty();
}

}  // namespace plumbline
