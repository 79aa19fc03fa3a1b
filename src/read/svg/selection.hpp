#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/read.hpp"
#include "read/attribute.hpp"
#include "read/layer_choice.hpp"
#include "read/svg/element.hpp"

namespace plumbline {

/// Which elements are read, by ReadOptions::hidden and the choice of layers. Counts the others by
/// the path of the groups that hold them and the reason.
class SvgSelection {
 public:
  struct Item {
    pugi::xml_node first;
    std::string path;
    Unusable problem;  ///< with the count in its reason
  };

  explicit SvgSelection(const ReadOptions& options)
      : choice_(options.layers, options.without_layers), draws_hidden_(options.hidden) {}

  /// Whether what is in the root is read wherever it is, and whether that in this element is.
  bool wants_all() const { return choice_.wants_all(); }
  bool wants(const pugi::xml_node& element) { return is_named(element, &LayerChoice::wants); }
  /// Whether an element is not read, which is then counted. `visible` as its visibility says,
  /// `wanted` for one on a layer that is.
  bool leaves_out(const pugi::xml_node& element, SvgKind kind, bool visible, bool wanted,
                  const std::string& path);
  /// What was left out, in the order in which it came. Throws: as LayerChoice::check.
  std::vector<Item> left_out(const std::string& file) const;

 private:
  struct Count {
    Item item;
    std::size_t count = 0;
  };

  bool is_named(const pugi::xml_node& element, bool (LayerChoice::*names)(std::string_view));
  void count(const pugi::xml_node& element, const std::string& path, Unusable problem);

  LayerChoice choice_;
  bool draws_hidden_;
  std::vector<Count> counts_;
  std::map<std::pair<std::string, std::string>, std::size_t> index_;  ///< by path and reason
};

}  // namespace plumbline
