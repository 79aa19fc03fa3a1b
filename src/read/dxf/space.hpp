#pragma once

#include <deque>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "read/dxf/insert.hpp"
#include "read/dxf/tally.hpp"

namespace plumbline::dxf {

/// An INSERT in its place.
struct Reference {
  Source source;
  std::string block_name;
  Insert insert;
  /// Whether what the block has on layer "0" is hidden: it lies on the layer of the insert.
  bool hides_layer_zero = false;
};

/// The model space or a block: what it draws, layer by layer.
struct Space {
  struct LayerItems {
    std::string name;
    std::deque<std::variant<Model, Reference>> items;
  };

  std::string name;  ///< empty for the model space
  Point base;
  std::uint32_t line = 0;
  std::vector<LayerItems> layers;  ///< in the order in which they occur
  std::map<std::string, std::size_t> layer_index;
  Tally tally;

  /// Adds an item to a layer.
  void add(const std::string& layer, std::variant<Model, Reference> item);
  /// The source with the names of the space and the layer as its path.
  Source placed(Source source, const std::string& layer) const;
};

/// All spaces of a drawing.
struct Drawing {
  std::vector<Space> spaces{1};               ///< the model space first
  std::map<std::string, std::size_t> blocks;  ///< by the key of their names
  Tally tally;                                ///< of what is in no space

  /// The hierarchy below the model space: each block, and each layer of it, is a Struct stored
  /// once. What a block has on layer "0" is in its own Struct, so it lies on the layer of each
  /// insert. Blocks that no insert reaches are left out. Throws: Error BadInput for a block within
  /// itself, naming the path and the line; Limit for arrays of more than kMaxArrayItems rows and
  /// columns.
  Structure structure(const std::string& file_name) &&;
};

/// Most rows and columns that the arrays of a drawing may have in all.
inline constexpr std::size_t kMaxArrayItems = std::size_t{1} << 22U;

}  // namespace plumbline::dxf
