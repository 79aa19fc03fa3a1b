#include "read/svg/unapplied.hpp"

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

bool has_property(const pugi::xml_node& element, const char* name) {
  const std::string_view value = presentation(element, name);
  return !value.empty() && value != "none";
}

/// What has this property, counted with the first of them.
void add_property(const pugi::xml_node& root, const char* name, std::vector<SvgUnapplied>& list) {
  std::size_t count = 0;
  pugi::xml_node first;
  for (auto node = root; node; node = next_below(root, node)) {
    if (node.type() != pugi::node_element || !has_property(node, name)) continue;
    if (count++ == 0) first = node;
  }
  if (count == 0) return;
  const std::string what = std::string(name) + " is not applied: what it hides is drawn";
  list.push_back({first, count == 1 ? what : what + " (" + std::to_string(count) + " of them)",
                  std::string(presentation(first, name))});
}

}  // namespace

std::vector<SvgUnapplied> unapplied(const pugi::xml_node& root, const SvgIndex& index) {
  std::vector<SvgUnapplied> list;
  add_root(root, list);
  add_style_sheets(index, list);
  for (const char* name : {"clip-path", "mask"}) add_property(root, name, list);
  return list;
}

}  // namespace plumbline
