#include "read/dxf/tables.hpp"

#include <utility>

namespace plumbline::dxf {

Header header_of(const Record& section) {
  constexpr int kVariable = 9;
  Header header;
  std::string_view variable;
  for (const Group& group : section.groups) {
    if (group.code == kVariable) {
      variable = group.value;
    } else if (variable == "$ACADVER") {
      header.version = group.value;
    } else if (variable == "$DWGCODEPAGE") {
      header.code_page = group.value;
    }
  }
  return header;
}

void Layers::add(const Entity& entry) {
  constexpr int kName = 2;
  constexpr int kColour = 62;
  constexpr std::int64_t kFrozen = 1;
  if (entry.text(kName).empty()) throw Unusable{"layer without a name", {}};
  Layer layer{names_.utf8(entry.text(kName)), LayerState::Shown};
  if (entry.integer(kColour, 1) < 0) layer.state = LayerState::Off;
  if ((entry.integer(kFlags, 0) & kFrozen) != 0) layer.state = LayerState::Frozen;
  layers_.insert_or_assign(names_.key(entry.text(kName)), std::move(layer));
}

Layers::Layer Layers::of(const Entity& entity) const {
  constexpr int kLayer = 8;
  const std::string_view name = entity.has(kLayer) ? entity.text(kLayer) : "0";
  const auto found = layers_.find(names_.key(name));
  return found != layers_.end() ? found->second : Layer{names_.utf8(name), LayerState::Shown};
}

}  // namespace plumbline::dxf
