#include "read/dxf/space.hpp"

#include <utility>

#include "read/dxf/assembly.hpp"
#include "read/dxf/reach.hpp"
#include "structure/name_path.hpp"

namespace plumbline::dxf {
namespace {

void list_missing_blocks(Space& space, const std::map<std::string, std::size_t>& blocks) {
  for (const auto& layer : space.layers) {
    for (const auto& item : layer.items) {
      const Reference* reference = std::get_if<Reference>(&item);
      if (reference == nullptr || blocks.count(reference->insert.block) != 0) continue;
      space.tally.refuse(space.placed(reference->source, layer.name),
                         {"no block of this name", reference->block_name});
    }
  }
}

}  // namespace

void Space::add(const std::string& layer, std::variant<Model, Reference> item) {
  const auto [found, is_new] = layer_index.try_emplace(layer, layers.size());
  if (is_new) layers.push_back({layer, {}});
  layers[found->second].items.push_back(std::move(item));
}

Source Space::placed(Source source, const std::string& layer) const {
  NamePath path;
  path.push(name);
  path.push(layer);
  source.path = path.text();
  return source;
}

Structure Drawing::structure(const std::string& file_name) && {
  const std::vector<bool> reached = reached_spaces(*this, file_name);
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    if (reached[s]) {
      list_missing_blocks(spaces[s], blocks);
      tally.merge(std::move(spaces[s].tally));
    } else if (!spaces[s].layers.empty()) {
      tally.leave_out({0, spaces[s].line, 0, "BLOCK", spaces[s].name, {}},
                      "block that is never inserted", true);
    }
  }
  Structure structure = assemble(*this, file_name);
  tally.append_to(structure);
  return structure;
}

}  // namespace plumbline::dxf
