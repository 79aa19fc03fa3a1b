// Structures made from structures: filtered, embedded.

#include <utility>

#include "plumbline/structure.hpp"
#include "structure/check.hpp"
#include "structure/replaced_rotations.hpp"

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

/// The structure without what its root does not lead to and what holds no models, in the order of
/// the Structs.
Structure pruned(Structure structure) {
  const Checked checked = check(structure);
  std::vector<StructId> place(structure.structs.size());
  std::vector<Struct> kept;
  for (std::size_t s = 0; s < structure.structs.size(); ++s) {
    if (checked.instances[s] == 0 && s != structure.root) continue;
    place[s] = StructId(kept.size());
    kept.push_back(std::move(structure.structs[s]));
  }
  for (Struct& s : kept) {
    std::vector<Struct::Item> body;
    for (Struct::Item& item : s.body) {
      auto* id = std::get_if<StructId>(&item);
      if (id != nullptr) *id = place[*id];
      if (id == nullptr || id->valid()) body.push_back(std::move(item));
    }
    s.body = std::move(body);
  }
  structure.root = place[structure.root];
  structure.structs = std::move(kept);
  return structure;
}

}  // namespace

Structure embed(const Structure& structure, int k) {
  Structure result = changed(structure, [&structure, k](Struct::Item item) -> Struct::Item {
    if (const auto* turn = std::get_if<Turn>(&item)) {
      return embed(rotation(turn->degrees, structure.angle_bound).map, k);
    }
    if (const auto* map = std::get_if<Affine>(&item)) return embed(*map, k);
    if (const auto* model = std::get_if<Model>(&item)) return embed(lar_model(*model), k);
    return embed(std::get<LarModel>(item), k);
  });
  ReplacedRotations replaced;
  Rotations rotations(structure.angle_bound);
  for (const Struct& s : structure.structs) {
    for (const Struct::Item& item : s.body) {
      if (!std::holds_alternative<Turn>(item)) continue;
      Placement alone(2);
      alone.append(item, rotations);
      replaced.add(alone, rotations);
    }
  }
  for (Replacement& entry : replaced.ledger(structure.angle_bound)) {
    result.ledger.push_back(std::move(entry));
  }
  return result;
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
      if (is_map(item)) bare.body.push_back(item);
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
  return pruned(std::move(result));
}

}  // namespace plumbline
