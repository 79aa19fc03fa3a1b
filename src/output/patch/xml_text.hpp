#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline::patch {

/// An element of an XML text, by its bytes.
struct XmlElement {
  std::size_t begin = 0, end = 0;  ///< all of it
  std::string_view name;
  std::string_view content;  ///< between its tags
  /// Names and values with their quotes, as they are written.
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
};

/// Where its lines begin, the first one first.
std::vector<std::size_t> line_begins(std::string_view text);

/// The element whose '<' is there; none where no whole element is. Requires: the text is
/// well-formed.
std::optional<XmlElement> element_at(std::string_view text, std::size_t begin);

}  // namespace plumbline::patch
