#include "read/svg/style.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "read/attribute.hpp"

namespace plumbline {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

struct Declaration {
  std::string_view name, value;
};

/// The first declaration of a style, which is moved behind it.
Declaration take_declaration(std::string_view& style) {
  const std::string_view text = style.substr(0, style.find(';'));
  style.remove_prefix(std::min(text.size() + 1, style.size()));
  const std::size_t colon = std::min(text.find(':'), text.size());
  std::string_view value = text.substr(std::min(colon + 1, text.size()));
  value = value.substr(0, value.find('!'));
  return {trimmed(text.substr(0, colon)), trimmed(value)};
}

bool among(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a property of a style would change the geometry of such an element.
bool is_geometric(std::string_view property, std::string_view element_name) {
  if (among(property, {"transform", "transform-origin", "translate", "rotate", "scale", "zoom"})) {
    return true;
  }
  if (element_name == "rect") return among(property, {"x", "y", "width", "height", "rx", "ry"});
  if (element_name == "circle") return among(property, {"cx", "cy", "r"});
  if (element_name == "ellipse") return among(property, {"cx", "cy", "rx", "ry"});
  if (element_name == "svg" || element_name == "use") return among(property, {"x", "y"});
  return element_name == "path" && property == "d";
}

}  // namespace

std::string_view style_property(std::string_view style, std::string_view name) {
  std::string_view value;
  while (!style.empty()) {
    const Declaration declaration = take_declaration(style);
    if (declaration.name == name) value = declaration.value;
  }
  return value;
}

std::string_view presentation(const pugi::xml_node& element, const char* name) {
  const std::string_view value = style_property(element.attribute("style").value(), name);
  return value.empty() ? trimmed(element.attribute(name).value()) : value;
}

bool is_displayed(const pugi::xml_node& element) {
  return presentation(element, "display") != "none";
}

std::optional<bool> own_visibility(const pugi::xml_node& element) {
  const std::string_view value = presentation(element, "visibility");
  if (value == "visible") return true;
  if (value == "hidden" || value == "collapse") return false;
  return std::nullopt;
}

void check_placement(const pugi::xml_node& element, std::string_view name) {
  const std::string_view style = element.attribute("style").value();
  for (std::string_view rest = style; !rest.empty();) {
    const Declaration declaration = take_declaration(rest);
    if (!is_geometric(declaration.name, name)) continue;
    throw Unusable{
        "property " + std::string(declaration.name) + " of a style is not understood yet",
        std::string(style)};
  }
  if (element.attribute("transform") && element.attribute("transform-origin")) {
    throw Unusable{"transform-origin is not understood yet",
                   element.attribute("transform-origin").value()};
  }
}

}  // namespace plumbline
