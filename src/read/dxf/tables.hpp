#pragma once

#include <map>
#include <string>
#include <vector>

#include "plumbline/read.hpp"
#include "read/dxf/entity.hpp"
#include "read/dxf/names.hpp"
#include "read/layer_choice.hpp"

namespace plumbline::dxf {

/// The variables of a HEADER that are read.
struct Header {
  std::string_view version;    ///< $ACADVER
  std::string_view code_page;  ///< $DWGCODEPAGE
  std::string_view units;      ///< $INSUNITS
};
/// Of a SECTION record that is a HEADER.
Header header_of(const Record& section);

/// Whether what is on a layer is drawn, and why not.
enum class LayerState { Shown, Off, NotPlotted, Frozen, LeftOut };

/// The layers of a drawing: those in the table, and others that entities name, which are shown.
class Layers {
 public:
  struct Layer {
    std::string name;  ///< as the table spells it
    LayerState state = LayerState::Shown;
    LayerState own = LayerState::Shown;  ///< but for the choice of layers
  };

  /// Shows hidden layers if the options say so, and leaves out what they leave out.
  Layers(const Names& names, const ReadOptions& options)
      : names_(names),
        choice_(options.layers, options.without_layers),
        draws_hidden_(options.hidden),
        draws_hatches_(options.hatches) {}
  /// Adds a LAYER record. Throws: Unusable for one without a name.
  void add(const Entity& entry);
  /// The layer that an entity names in its group 8, "0" where it names none; of a HATCH that is
  /// drawn one of its own, "A HATCH" for "A".
  const Layer& of(const Entity& entity);
  /// Those in the table, in its order.
  const std::vector<plumbline::Layer>& declared() const { return declared_; }
  /// Throws: as LayerChoice.
  void check_choice(const std::string& file) const { choice_.check(file); }

 private:
  /// A layer that is not in the table.
  const Layer& add(std::string key, Layer layer);

  const Names& names_;
  LayerChoice choice_;
  bool draws_hidden_, draws_hatches_;
  std::map<std::string, Layer> layers_;  ///< by key
  std::vector<plumbline::Layer> declared_;
};

constexpr std::string_view kHatch = "HATCH";

/// "off": why a layer that is not shown is not.
const char* to_text(LayerState state);

}  // namespace plumbline::dxf
