// Spaces -> Structure: which blocks are reached, then one Struct each.

#include "read/dxf/space.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "plumbline/error.hpp"
#include "structure/name_path.hpp"

namespace plumbline::dxf {
namespace {

constexpr const char* kLayerZero = "0";

const Reference* reference_of(const std::variant<Model, Reference>& item) {
  return std::get_if<Reference>(&item);
}

/// Finds the spaces below the model space, without recursion.
class Reach {
 public:
  explicit Reach(const Drawing& drawing, const std::string& file_name)
      : drawing_(drawing), file_name_(file_name), state_(drawing.spaces.size(), State::New) {}

  /// Per space: whether it is reached. Throws: Error BadInput for a cycle.
  std::vector<bool> find() && {
    enter(0);
    while (!open_.empty()) {
      auto& [space, next] = open_.back();
      const std::vector<const Reference*>& references = references_.back();
      if (next == references.size()) {
        state_[space] = State::Done;
        open_.pop_back();
        references_.pop_back();
      } else {
        follow(*references[next++]);
      }
    }
    std::vector<bool> reached;
    for (const State state : state_) reached.push_back(state == State::Done);
    return reached;
  }

 private:
  enum class State { New, Open, Done };
  struct Frame {
    std::size_t space;
    std::size_t next;  ///< index into its references
  };

  void enter(std::size_t space) {
    state_[space] = State::Open;
    open_.push_back({space, 0});
    references_.emplace_back();
    for (const auto& layer : drawing_.spaces[space].layers) {
      for (const auto& item : layer.items) {
        if (const Reference* reference = reference_of(item))
          references_.back().push_back(reference);
      }
    }
  }

  void follow(const Reference& reference) {
    const auto block = drawing_.blocks.find(reference.insert.block);
    if (block == drawing_.blocks.end()) return;
    if (state_[block->second] == State::Open) fail(reference, block->second);
    if (state_[block->second] == State::New) enter(block->second);
  }

  [[noreturn]] void fail(const Reference& reference, std::size_t repeated) const {
    std::string path;
    bool inside = false;
    for (const Frame& frame : open_) {
      inside = inside || frame.space == repeated;
      if (inside) path += drawing_.spaces[frame.space].name + "/";
    }
    throw Error(ErrorCode::BadInput, "a block is inserted in itself",
                {file_name_, reference.source.line, 0}, path + drawing_.spaces[repeated].name);
  }

  const Drawing& drawing_;
  const std::string& file_name_;
  std::vector<State> state_;
  std::vector<Frame> open_;
  std::vector<std::vector<const Reference*>> references_;  ///< per frame
};

/// Makes the Structs. A Struct gets its id when it is first referred to, and its body later.
class Assembly {
 public:
  Assembly(Drawing& drawing, const std::string& file_name)
      : drawing_(drawing), made_(drawing.spaces.size()) {
    structure_.files = {file_name};
  }

  Structure run() && {
    for (std::size_t s = 0; s < made_.size(); ++s) {
      made_[s].layers.resize(drawing_.spaces[s].layers.size());
    }
    structure_.root = struct_of(0, false);
    while (!waiting_.empty()) {
      const Part part = waiting_.back();
      waiting_.pop_back();
      fill(part);
    }
    return std::move(structure_);
  }

 private:
  /// A space, or what remains of it without the lines of its layer "0".
  struct Part {
    std::size_t space;
    bool without_zero;
    StructId id;
  };
  struct Made {
    std::array<std::optional<StructId>, 2> whole;  ///< indexed by without_zero
    std::vector<std::optional<StructId>> layers;
  };

  StructId append(Struct made) {
    structure_.structs.push_back(std::move(made));
    return StructId(structure_.structs.size() - 1);
  }

  StructId struct_of(std::size_t space, bool without_zero) {
    std::optional<StructId>& id = made_[space].whole[without_zero ? 1 : 0];
    if (!id) {
      id = append({drawing_.spaces[space].name, space == 0 ? "" : "block", {}});
      waiting_.push_back({space, without_zero, *id});
    }
    return *id;
  }

  void fill(const Part& part) {
    auto& layers = drawing_.spaces[part.space].layers;
    std::vector<Struct::Item> body;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      if (part.space != 0 && layers[i].name == kLayerZero) {
        append_items(body, layers[i], part.without_zero);
      } else {
        body.emplace_back(layer_struct(part.space, i));
      }
    }
    structure_.structs[part.id].body = std::move(body);
  }

  StructId layer_struct(std::size_t space, std::size_t index) {
    std::optional<StructId>& id = made_[space].layers[index];
    if (!id) {
      auto& layer = drawing_.spaces[space].layers[index];
      Struct made{layer.name, "layer", {}};
      append_items(made.body, layer, false);
      id = append(std::move(made));
    }
    return *id;
  }

  void append_items(std::vector<Struct::Item>& body, Space::LayerItems& layer, bool without_zero) {
    body.reserve(body.size() + layer.items.size());
    for (auto& item : layer.items) {
      if (const Reference* reference = reference_of(item)) {
        const auto block = drawing_.blocks.find(reference->insert.block);
        if (block == drawing_.blocks.end()) continue;  // listed before
        const bool hides = without_zero || reference->hides_layer_zero;
        body.emplace_back(placed(reference->insert, drawing_.spaces[block->second].base,
                                 struct_of(block->second, hides)));
      } else if (!without_zero) {  // so each Model is asked for once
        body.emplace_back(std::move(std::get<Model>(item)));
      }
    }
  }

  /// The copies of a block in their places.
  StructId placed(const Insert& insert, const Point& base, StructId block) {
    const Affine local = compose(insert.scale, translation(-base.x, -base.y));
    if (insert.columns == 1 && insert.rows == 1) {
      return mapped(compose(insert.placement, local), block);
    }
    spend(insert.columns + insert.rows);
    const StructId cell = mapped(local, block);
    const StructId row = repeated(cell, insert.columns, translation(insert.column_distance, 0));
    return mapped(insert.placement,
                  repeated(row, insert.rows, translation(0, insert.row_distance)));
  }

  StructId mapped(const Affine& map, StructId id) {
    if (map == Affine{}) return id;
    Struct made;
    made.body.reserve(2);
    made.body.emplace_back(map);
    made.body.emplace_back(id);
    return append(std::move(made));
  }

  StructId repeated(StructId id, std::size_t count, const Affine& step) {
    if (count == 1) return id;
    Struct made;
    made.body.reserve(2 * count - 1);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) made.body.emplace_back(step);
      made.body.emplace_back(id);
    }
    return append(std::move(made));
  }

  void spend(std::size_t items) {
    if (items > items_left_) {
      throw Error(ErrorCode::Limit, "the arrays have more than " + std::to_string(kMaxArrayItems) +
                                        " rows and columns");
    }
    items_left_ -= items;
  }

  Drawing& drawing_;
  Structure structure_;
  std::vector<Made> made_;
  std::vector<Part> waiting_;
  std::size_t items_left_ = kMaxArrayItems;
};

void list_missing_blocks(Space& space, const std::map<std::string, std::size_t>& blocks) {
  for (const auto& layer : space.layers) {
    for (const auto& item : layer.items) {
      const Reference* reference = reference_of(item);
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
  const std::vector<bool> reached = Reach(*this, file_name).find();
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    if (reached[s]) {
      list_missing_blocks(spaces[s], blocks);
      tally.merge(std::move(spaces[s].tally));
    } else if (!spaces[s].layers.empty()) {
      tally.leave_out({0, spaces[s].line, 0, "BLOCK", spaces[s].name, {}},
                      "block that is never inserted");
    }
  }
  Structure structure = Assembly(*this, file_name).run();
  tally.append_to(structure);
  return structure;
}

}  // namespace plumbline::dxf
