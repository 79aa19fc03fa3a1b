#pragma once

#include <pugixml.hpp>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace plumbline {

/// Collects what is not drawn in its place (defs, symbol, ...) until it is known what was drawn
/// through a `use`.
class SvgUndrawn {
 public:
  struct Item {
    pugi::xml_node element;
    std::string path;  ///< of the groups above it
  };

  void add(const pugi::xml_node& element, std::string path);
  void used(const pugi::xml_node& element);
  /// The topmost elements that hold a drawing of which nothing was used.
  std::vector<Item> unused() const;

 private:
  using Elements = std::unordered_set<const void*>;

  std::vector<Item> items_;
  Elements used_;
  Elements above_used_;
};

}  // namespace plumbline
