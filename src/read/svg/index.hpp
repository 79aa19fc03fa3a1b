#pragma once

#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace plumbline {

/// What must be known of a document before it is walked.
class SvgIndex {
 public:
  explicit SvgIndex(const pugi::xml_node& root);

  /// Whether the element is of the SVG namespace. A document that declares no namespace at all
  /// counts as SVG.
  bool is_svg(const pugi::xml_node& element) const {
    return foreign_.count(element.internal_object()) == 0;
  }
  /// The first element with this id, or a null node.
  pugi::xml_node find(std::string_view id) const;
  const std::vector<pugi::xml_node>& style_sheets() const { return style_sheets_; }
  /// The groups that are layers, as Inkscape marks them.
  const std::vector<pugi::xml_node>& layers() const { return layers_; }
  /// Whether a `use` refers to the element.
  bool is_referenced(const pugi::xml_node& element) const {
    return referenced_.count(element.internal_object()) != 0;
  }

 private:
  using Elements = std::unordered_set<const void*>;

  void add(const pugi::xml_node& element, bool is_svg);

  std::vector<pugi::xml_node> style_sheets_;
  std::vector<pugi::xml_node> layers_;
  Elements foreign_;
  Elements referenced_;
  std::unordered_map<std::string_view, pugi::xml_node> by_id_;
};

/// What a `use` refers to: its href or xlink:href, empty where there is none.
std::string_view svg_reference(const pugi::xml_node& element);

}  // namespace plumbline
