#include "read/dxf/assembly.hpp"

#include <array>
#include <optional>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::dxf {
namespace {

/// Makes the Structs. A Struct gets its id when it is first referred to, and its body later.
class Assembly {
 public:
  Assembly(Drawing& drawing, const std::string& file_name)
      : drawing_(drawing), structs_of_(drawing.spaces.size()) {
    structure_.files = {file_name};
    structure_.y_up = true;
  }

  Structure run() && {
    for (std::size_t s = 0; s < structs_of_.size(); ++s) {
      structs_of_[s].layers.resize(drawing_.spaces[s].layers.size());
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
  /// The Structs made so far of a space.
  struct SpaceStructs {
    std::array<std::optional<StructId>, 2> whole;  ///< indexed by without_zero
    std::vector<std::optional<StructId>> layers;
  };

  StructId append(Struct made) {
    structure_.structs.push_back(std::move(made));
    return StructId(structure_.structs.size() - 1);
  }

  StructId struct_of(std::size_t space, bool without_zero) {
    std::optional<StructId>& id = structs_of_[space].whole[without_zero ? 1 : 0];
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
    std::optional<StructId>& id = structs_of_[space].layers[index];
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
      if (const Reference* reference = std::get_if<Reference>(&item)) {
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
    if (insert.columns == 1 && insert.rows == 1) return placed(insert, local, block);
    spend(insert.columns + insert.rows);
    const StructId cell = mapped({local}, block);
    const StructId row = repeated(cell, insert.columns, translation(insert.column_distance, 0));
    return placed(insert, Affine(),
                  repeated(row, insert.rows, translation(0, insert.row_distance)));
  }

  /// First `local`, then rotation and place of the insert; in one where that is exact.
  StructId placed(const Insert& insert, const Affine& local, StructId id) {
    const auto* exact = std::get_if<Affine>(&insert.turn);
    if (exact == nullptr) return mapped({insert.place, insert.turn, local}, id);
    return mapped({compose(insert.place, compose(*exact, local))}, id);
  }

  StructId mapped(std::vector<Struct::Item> maps, StructId id) {
    std::erase(maps, Struct::Item(Affine()));
    if (maps.empty()) return id;
    Struct made{"", "", std::move(maps)};
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
  std::vector<SpaceStructs> structs_of_;
  std::vector<Part> waiting_;
  std::size_t items_left_ = kMaxArrayItems;
};

}  // namespace

Structure assemble(Drawing& drawing, const std::string& file_name) {
  return Assembly(drawing, file_name).run();
}

}  // namespace plumbline::dxf
