#pragma once

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/error.hpp"

namespace plumbline {

/// A well-formed XML document whose nodes know their place in the text. The entities that its
/// DOCTYPE declares are replaced in attributes. Beyond what pugixml checks, it refuses: a second
/// root, text outside the root, duplicate attributes, invalid encoding.
class XmlDocument {
 public:
  /// From 1; 0 means unknown.
  struct Position {
    std::uint32_t line = 0, column = 0;
  };

  /// Throws: Error BadInput with the place, Limit.
  XmlDocument(std::string_view bytes, const std::string& file);

  pugi::xml_node root() const { return document_.document_element(); }
  /// Of the element's '<'.
  Position position(const pugi::xml_node& element) const;
  Place place(const pugi::xml_node& element) const { return place_at(position(element)); }

 private:
  [[noreturn]] void fail(const std::string& message, std::size_t offset,
                         const std::string& text = {}) const;
  Position position_at(std::size_t offset) const;
  Place place_at(Position position) const { return {file_, position.line, position.column}; }
  void parse();
  void check_top_level() const;
  void check_attributes() const;
  void expand_entities(class Entities& entities) const;
  void check_entities(const class Entities& entities, const pugi::xml_node& text) const;

  std::string file_;
  std::string text_;  ///< parsed in place: holds the names and values
  std::vector<std::size_t> line_begins_;
  pugi::xml_document document_;
};

/// The node that follows in document order below `top`, or a null node. Constant memory at any
/// depth.
pugi::xml_node next_below(const pugi::xml_node& top, const pugi::xml_node& node);

}  // namespace plumbline
