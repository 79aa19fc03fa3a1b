#include "read/svg/unapplied.hpp"

#include <array>
#include <cstring>

#include "read/attribute.hpp"
#include "read/svg/element.hpp"
#include "read/svg/style.hpp"
#include "read/xml.hpp"

namespace plumbline {
namespace {

/// Coordinates are user units of the root's viewBox. What maps them to a page from outside is
/// listed.
void add_root(const pugi::xml_node& root, std::vector<SvgUnapplied>& list) {
  try {
    check_placement(root, "svg");
  } catch (const Unusable& problem) {
    list.push_back({root, problem.reason, problem.text});
  }
  const pugi::xml_attribute transform = root.attribute("transform");
  if (!transform) return;
  list.push_back({root,
                  "transform of the root svg maps its user units to the page; it is not applied",
                  transform.value()});
}

void add_style_sheets(const SvgIndex& index, std::vector<SvgUnapplied>& list) {
  for (const pugi::xml_node& element : index.style_sheets()) {
    const std::string_view sheet = element.child_value();
    for (const char* word : {"transform", "display", "visibility"}) {
      if (sheet.find(word) == sheet.npos) continue;
      list.push_back(
          {element, "style sheets are not interpreted: " + std::string(word), std::string(sheet)});
      break;
    }
  }
}

/// Whether an element may have a property: a cheap look at the texts of its attributes.
bool mentions(const pugi::xml_node& element, const char* property) {
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name == property) return true;
    if (name == "style" && std::strstr(attribute.value(), property) != nullptr) return true;
  }
  return false;
}

/// What has each of these properties, counted with the first of them.
void add_properties(const pugi::xml_node& root, std::vector<SvgUnapplied>& list) {
  struct Found {
    const char* name;
    pugi::xml_node first;
    std::size_t count = 0;
  };
  std::array<Found, 2> all{{{"clip-path", {}}, {"mask", {}}}};
  for (auto node = root; node; node = next_below(root, node)) {
    for (Found& found : all) {
      if (!mentions(node, found.name)) continue;
      const std::string_view value = presentation(node, found.name);
      if (value.empty() || value == "none") continue;
      if (found.count++ == 0) found.first = node;
    }
  }
  for (const Found& found : all) {
    if (found.count == 0) continue;
    std::string what = std::string(found.name) + " is not applied: what it hides is drawn";
    if (found.count > 1) what += " (" + std::to_string(found.count) + " of them)";
    list.push_back({found.first, what, std::string(presentation(found.first, found.name))});
  }
}

}  // namespace

std::vector<SvgUnapplied> unapplied(const pugi::xml_node& root, const SvgIndex& index) {
  std::vector<SvgUnapplied> list;
  add_root(root, list);
  add_style_sheets(index, list);
  add_properties(root, list);
  return list;
}

}  // namespace plumbline
