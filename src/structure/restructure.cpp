// Structures made from structures: filtered, embedded.

#include <utility>

#include "plumbline/structure.hpp"

namespace plumbline {
namespace {

/// A copy in which every item is what `change` makes of it.
template <class Change>
Structure changed(const Structure& structure, Change change) {
  Structure result = structure;
  for (Struct& s : result.structs) {
    for (Struct::Item& item : s.body) {
      if (!std::holds_alternative<StructId>(item)) item = change(std::move(item));
    }
  }
  return result;
}

}  // namespace

Structure embed(const Structure& structure, int k) {
  return changed(structure, [k](Struct::Item item) -> Struct::Item {
    if (const auto* map = std::get_if<Affine>(&item)) return embed(*map, k);
    if (const auto* model = std::get_if<Model>(&item)) return embed(lar_model(*model), k);
    return embed(std::get<LarModel>(item), k);
  });
}

Structure filter(const Structure& structure, const std::string& category) {
  // Every Struct twice: as it is, for what stands within the category, and without its models.
  Structure result = structure;
  const std::size_t count = structure.structs.size();
  result.structs.reserve(2 * count);
  for (std::size_t s = 0; s < count; ++s) {
    const Struct& whole = structure.structs[s];
    Struct bare{whole.name, whole.category, {}};
    for (const Struct::Item& item : whole.body) {
      if (std::holds_alternative<Affine>(item)) bare.body.push_back(item);
      const auto* id = std::get_if<StructId>(&item);
      if (id == nullptr) continue;
      const bool keeps = *id < count && structure.structs[*id].category != category;
      bare.body.emplace_back(keeps ? StructId(*id + count) : *id);
    }
    result.structs.push_back(std::move(bare));
  }
  if (structure.root < count && structure.structs[structure.root].category != category) {
    result.root = StructId(structure.root + count);
  }
  return result;
}

}  // namespace plumbline
