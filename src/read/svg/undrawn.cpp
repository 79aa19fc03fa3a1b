#include "read/svg/undrawn.hpp"

#include "read/svg/element.hpp"

namespace plumbline {

void SvgUndrawn::add(const pugi::xml_node& element, std::string path) {
  items_.push_back({element, std::move(path)});
}

void SvgUndrawn::used(const pugi::xml_node& element) {
  used_.insert(element.internal_object());
  for (auto up = element.parent(); up; up = up.parent()) {
    if (!above_used_.insert(up.internal_object()).second) return;
  }
}

std::vector<SvgUndrawn::Item> SvgUndrawn::unused() const {
  std::vector<Item> result;
  std::vector<pugi::xml_node> open;
  for (const Item& item : items_) {
    open.push_back(item.element);
    while (!open.empty()) {
      const pugi::xml_node node = open.back();
      open.pop_back();
      if (used_.count(node.internal_object()) != 0) continue;
      if (above_used_.count(node.internal_object()) == 0) {
        if (holds_drawing(node)) result.push_back({node, item.path});
        continue;
      }
      for (auto child = node.last_child(); child; child = child.previous_sibling()) {
        open.push_back(child);
      }
    }
  }
  return result;
}

}  // namespace plumbline
