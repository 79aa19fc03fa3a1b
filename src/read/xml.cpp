#include "read/xml.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "read/encoding.hpp"
#include "read/entities.hpp"

namespace plumbline {
namespace {

std::vector<std::size_t> line_begins(std::string_view text) {
  std::vector<std::size_t> begins{0};
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) {
    begins.push_back(end + 1);
  }
  return begins;
}

/// A name that is in the list twice, or null.
const char* repeated(std::vector<const char*>& names) {
  constexpr std::size_t kFew = 16;  // so many are compared in pairs; more are sorted
  const auto equal = [](const char* a, const char* b) {
    return *a == *b && std::strcmp(a, b) == 0;
  };
  if (names.size() > kFew) {
    const auto less = [](const char* a, const char* b) { return std::strcmp(a, b) < 0; };
    std::sort(names.begin(), names.end(), less);
    const auto twice = std::adjacent_find(names.begin(), names.end(), equal);
    return twice == names.end() ? nullptr : *twice;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (equal(names[i], names[j])) return names[i];
    }
  }
  return nullptr;
}

}  // namespace

pugi::xml_node next_below(const pugi::xml_node& top, const pugi::xml_node& node) {
  if (node.first_child()) return node.first_child();
  for (pugi::xml_node up = node; up != top; up = up.parent()) {
    if (up.next_sibling()) return up.next_sibling();
  }
  return {};
}

XmlDocument::XmlDocument(std::string_view bytes, const std::string& file)
    : file_(file), text_(to_utf8(bytes, file)), line_begins_(line_begins(text_)) {
  parse();
  check_top_level();
  check_attributes();
  std::string doctype;
  for (const auto& node : document_.children()) {
    if (node.type() == pugi::node_doctype) doctype += node.value();
  }
  Entities entities(doctype);
  if (!entities.empty()) expand_entities(entities);
}

void XmlDocument::parse() {
  // As a fragment, text outside the root is kept for check_top_level instead of being dropped.
  const unsigned options = pugi::parse_default | pugi::parse_doctype | pugi::parse_fragment;
  const auto result =
      document_.load_buffer_inplace(text_.data(), text_.size(), options, pugi::encoding_utf8);
  if (!result) {
    std::string reason = result.description();
    reason[0] = static_cast<char>(std::tolower(reason[0]));
    fail("malformed XML: " + reason, static_cast<std::size_t>(std::max(result.offset, 0L)));
  }
}

void XmlDocument::check_top_level() const {
  if (!root()) fail("malformed XML: no element", 0);
  for (const auto& node : document_.children()) {
    if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) {
      const std::string_view text = node.value();
      const std::size_t blanks = std::min(text.find_first_not_of(" \t\r\n"), text.size());
      const auto offset = static_cast<std::size_t>(std::max(node.offset_debug(), 0L));
      fail("malformed XML: text outside the root element", offset + blanks,
           std::string(text.substr(blanks)));
    }
    if (node.type() == pugi::node_element && node != root()) {
      throw Error(ErrorCode::BadInput, "malformed XML: second root element", place(node),
                  node.name());
    }
  }
}

void XmlDocument::check_attributes() const {
  std::vector<const char*> names;
  for (auto node = root(); node; node = next_below(root(), node)) {
    names.clear();
    for (auto a = node.first_attribute(); a; a = a.next_attribute()) names.push_back(a.name());
    if (const char* name = repeated(names)) {
      throw Error(ErrorCode::BadInput, "malformed XML: duplicate attribute", place(node), name);
    }
  }
}

void XmlDocument::check_entities(const Entities& entities, const pugi::xml_node& text) const {
  if (entities.refers_to_markup(text.value())) {
    throw Error(ErrorCode::BadInput, "an entity with markup is not understood yet",
                place(text.parent()), text.value());
  }
  try {
    entities.check_external(text.value());
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), place(text.parent()), error.offending_text());
  }
}

void XmlDocument::expand_entities(Entities& entities) const {
  for (auto node = root(); node; node = next_below(root(), node)) {
    if (node.type() == pugi::node_pcdata) check_entities(entities, node);
    for (auto attribute : node.attributes()) {
      const std::string_view value = attribute.value();
      if (value.find('&') == value.npos) continue;
      try {
        attribute.set_value(entities.expand(value).c_str());
      } catch (const Error& error) {
        throw Error(error.code(), error.message(), place(node), error.offending_text());
      }
    }
  }
}

XmlDocument::Position XmlDocument::position_at(std::size_t offset) const {
  const auto next = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - line_begins_.begin());
  return {line, static_cast<std::uint32_t>(offset - line_begins_[line - 1] + 1)};
}

XmlDocument::Position XmlDocument::position(const pugi::xml_node& element) const {
  const auto name = element.offset_debug();
  if (name < 1) return {};
  return position_at(static_cast<std::size_t>(name - 1));
}

void XmlDocument::fail(const std::string& message, std::size_t offset,
                       const std::string& text) const {
  throw Error(ErrorCode::BadInput, message, place_at(position_at(offset)), text);
}

}  // namespace plumbline
