#include "read/svg/index.hpp"

#include <string>
#include <vector>

#include "read/svg/element.hpp"

namespace plumbline {

SvgIndex::SvgIndex(const pugi::xml_node& root) {
  Namespaces namespaces;
  std::vector<std::string_view> references;
  const auto enter = [&](const pugi::xml_node& node) {
    if (node.type() != pugi::node_element) return;
    namespaces.enter(node);
    add(node, namespaces.is_svg(node));
    if (local_name(node) == "use") references.push_back(svg_reference(node));
  };
  const auto leave = [&](const pugi::xml_node& node) {
    if (node.type() == pugi::node_element) namespaces.leave();
  };
  pugi::xml_node node = root;
  enter(node);
  while (true) {
    pugi::xml_node next = node.first_child();
    for (; !next && node != root; node = node.parent()) {
      leave(node);
      next = node.next_sibling();
    }
    if (!next) break;
    enter(node = next);
  }
  for (const std::string_view reference : references) {
    if (!reference.starts_with('#')) continue;
    if (const auto target = find(reference.substr(1))) {
      referenced_.insert(target.internal_object());
    }
  }
}

void SvgIndex::add(const pugi::xml_node& element, bool is_svg) {
  if (!is_svg) foreign_.insert(element.internal_object());
  if (is_svg && local_name(element) == "style") style_sheets_.push_back(element);
  if (element.attribute("inkscape:groupmode").value() == std::string_view("layer")) {
    layers_.push_back(element);
  }
  const std::string_view id = element.attribute("id").value();
  if (!id.empty()) by_id_.emplace(id, element);
}

pugi::xml_node SvgIndex::find(std::string_view id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

std::string_view svg_reference(const pugi::xml_node& element) {
  const pugi::xml_attribute plain = element.attribute("href");
  if (plain) return plain.value();
  for (const auto& attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name.ends_with(":href")) return attribute.value();
  }
  return {};
}

}  // namespace plumbline
