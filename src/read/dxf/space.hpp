#pragma once

#include <deque>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "read/dxf/insert.hpp"
#include "read/dxf/tally.hpp"

namespace plumbline::dxf {

/// The layer on which what a block has takes the layer of the INSERT.
constexpr const char* kLayerZero = "0";

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

  /// The hierarchy below the model space, and what its spaces refuse and replace; blocks that no
  /// insert reaches are listed only. Throws: as `reached_spaces` and `assemble`.
  Structure structure(const std::string& file_name) &&;
};

}  // namespace plumbline::dxf
