#include "read/dxf/tables.hpp"

#include <utility>

#include "structure/colour_index.hpp"

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
    } else if (variable == "$INSUNITS") {
      header.units = group.value;
    }
  }
  return header;
}

void Layers::add(const Entity& entry) {
  constexpr int kName = 2;
  constexpr int kColour = 62;
  constexpr int kTrueColour = 420;
  constexpr int kPlotted = 290;
  constexpr std::int64_t kFrozen = 1;
  const std::string key = names_.key(entry.text(kName));
  if (key.empty()) throw Unusable{"layer without a name", {}};
  Layer layer{names_.utf8(entry.text(kName))};
  const std::int64_t colour = entry.integer(kColour, 1);
  // Defpoints is never plotted, whatever the table says.
  if (entry.integer(kPlotted, 1) == 0 || key == "defpoints") layer.state = LayerState::NotPlotted;
  if (colour < 0) layer.state = LayerState::Off;
  if ((entry.integer(kFlags, 0) & kFrozen) != 0) layer.state = LayerState::Frozen;
  const bool is_hidden = layer.state != LayerState::Shown;
  const std::int64_t rgb = entry.integer(kTrueColour, -1);
  const bool has_rgb = rgb >= 0 && rgb <= 0xffffff;
  const auto own = has_rgb ? std::optional(static_cast<std::uint32_t>(rgb))
                           : rgb_of_colour(colour < 0 ? -colour : colour);
  if (draws_hidden_) layer.state = LayerState::Shown;
  layer.own = layer.state;
  if (!choice_.takes(layer.name)) layer.state = LayerState::LeftOut;
  declared_.push_back({layer.name, own, is_hidden});
  layers_.insert_or_assign(key, std::move(layer));
}

const Layers::Layer& Layers::add(std::string key, Layer layer) {
  layer.state = choice_.takes(layer.name) ? layer.own : LayerState::LeftOut;
  return layers_.emplace(std::move(key), std::move(layer)).first->second;
}

const Layers::Layer& Layers::of(const Entity& entity) {
  constexpr int kLayer = 8;
  const std::string_view name = entity.has(kLayer) ? entity.text(kLayer) : "0";
  std::string key = names_.key(name);
  const auto known = layers_.find(key);
  const Layer& layer =
      known != layers_.end() ? known->second : add(std::move(key), {names_.utf8(name)});
  if (!draws_hatches_ || entity.record().type != kHatch) return layer;
  const std::string own = layer.name + " " + std::string(kHatch);
  key = names_.key(own);
  const auto known_hatch = layers_.find(key);
  if (known_hatch != layers_.end()) return known_hatch->second;
  return add(std::move(key), {own, layer.own, layer.own});
}

const char* to_text(LayerState state) {
  switch (state) {
    case LayerState::Shown:
      return "shown";
    case LayerState::Off:
      return "off";
    case LayerState::NotPlotted:
      return "not plotted";
    case LayerState::Frozen:
      return "frozen";
    case LayerState::LeftOut:
      return "left out as asked";
  }
  return "";
}

}  // namespace plumbline::dxf
