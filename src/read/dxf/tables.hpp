#pragma once

#include <map>
#include <string>

#include "read/dxf/entity.hpp"
#include "read/dxf/names.hpp"

namespace plumbline::dxf {

/// The variables of a HEADER that are read.
struct Header {
  std::string_view version;    ///< $ACADVER
  std::string_view code_page;  ///< $DWGCODEPAGE
};
/// Of a SECTION record that is a HEADER.
Header header_of(const Record& section);

/// What a drawing does with a layer.
enum class LayerState { Shown, Off, Frozen };

/// The table of layers. A layer that is not in it is shown.
class Layers {
 public:
  struct Layer {
    std::string name;  ///< as the table spells it
    LayerState state = LayerState::Shown;
  };

  explicit Layers(const Names& names) : names_(names) {}
  /// Adds a LAYER record. Throws: Unusable for one without a name.
  void add(const Entity& entry);
  /// The layer that an entity names in its group 8; "0" where it names none.
  Layer of(const Entity& entity) const;

 private:
  const Names& names_;
  std::map<std::string, Layer> layers_;  ///< by key
};

}  // namespace plumbline::dxf
