#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/detail/iterator.hpp"

namespace plumbline {

/// The element of a drawing that an item came from.
struct Source {
  std::uint32_t file = 0;  ///< index into SegmentSet::files
  std::uint32_t line = 0;  ///< of the element's first character, from 1; 0 means unknown
  std::uint32_t column = 0;
  std::string element;  ///< its name in the format: "line", "rect", "path", "row", ...
  std::string id;       ///< its id in the file, if it has one
  std::string path;     ///< names of the groups or layers above it, outermost first, joined by '/'
  std::string layer = {};  ///< the layer that it lies on, where the format has layers

  friend bool operator==(const Source&, const Source&) = default;
};

/// "file:line:column element #id (path)", leaving out what is unknown.
std::string to_text(const Source& source, const std::vector<std::string>& files);

/// A sequence of Sources that stores once what successive ones share: 16 bytes each, and their ids.
class SourceList {
 public:
  using value_type = Source;
  using const_iterator = ValueIterator<SourceList>;

  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  /// Requires: i < size(); `at` throws std::out_of_range.
  Source operator[](std::size_t i) const;
  Source at(std::size_t i) const;
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, static_cast<std::ptrdiff_t>(size())}; }

  void reserve(std::size_t count) { rows_.reserve(count); }
  void push_back(const Source& source);

 private:
  struct Row {
    std::uint32_t line, column;
    std::uint32_t kind;
    std::uint32_t id;  ///< 0: none; else index into ids_ plus 1
  };
  std::uint32_t kind_of(const Source& source);

  std::vector<Row> rows_;
  std::vector<Source> kinds_;  ///< file, element, path and layer
  std::vector<std::string> ids_;
};

/// A layer that a drawing declares.
struct Layer {
  std::string name;
  std::optional<std::uint32_t> rgb;  ///< its colour, 0xRRGGBB
  bool hidden = false;               ///< off, frozen, not displayed or not printed

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// An item of the input that takes no part in the result, and why.
struct Rejected {
  Source source;
  std::string reason;
  std::string text;  ///< the offending text, shortened to 60 characters
  /// Whether no lines were lost with it: a text, an image, a point, what the drawing hides.
  bool harmless = false;

  friend bool operator==(const Rejected&, const Rejected&) = default;
};

/// How many of the items are not harmless: something that looks like lines was lost.
std::size_t count_lost(const std::vector<Rejected>& rejected);

/// What is to be said of an item that was drawn nevertheless: "ring is not closed; ...".
struct Remark {
  Source source;
  std::string what;
  std::string text;  ///< the text that it is about, shortened to 60 characters

  friend bool operator==(const Remark&, const Remark&) = default;
};

/// One replacement of a number on the way from the file to exact coordinates.
struct Replacement {
  Source source;
  std::string what;   ///< what was replaced, e.g. "rotate(30)"
  std::string bound;  ///< by how much at most, with its unit, e.g. "1e-15 rad"

  friend bool operator==(const Replacement&, const Replacement&) = default;
};

}  // namespace plumbline
