#include "read/svg/names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "read/svg/element.hpp"
#include "read/xml.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kBlankCharacters = " \t\r\n";

std::string with_single_blanks(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool is_blank = kBlankCharacters.find(c) != kBlankCharacters.npos;
    if (is_blank && (result.empty() || result.back() == ' ')) continue;
    result += is_blank ? ' ' : c;
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

bool is_characters(const pugi::xml_node& node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

/// All characters below an element. A new line of a text, which has a place of its own, and a
/// `tspan` next to another one begin with a blank.
std::string characters(const pugi::xml_node& top) {
  std::string result;
  for (auto node = top; node; node = next_below(top, node)) {
    if (is_characters(node)) {
      const std::string_view parent = local_name(node.parent());
      const bool is_said = node.parent() == top || (parent != "title" && parent != "desc");
      if (is_said) result += node.value();
    } else if (node != top && local_name(node) == "tspan") {
      const bool is_next = local_name(node.previous_sibling()) == "tspan";
      if (is_next || node.attribute("x") || node.attribute("y")) result += ' ';
    }
  }
  return with_single_blanks(result);
}

bool is_hexadecimal(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

/// The first of several lengths, of the text or the first `tspan` that has them.
Number first_length(const pugi::xml_node& text, const char* name,
                    const std::optional<Rational>& whole, Numbers& numbers) {
  for (auto node = text; node; node = next_below(text, node)) {
    std::string_view value = node.attribute(name).value();
    value.remove_prefix(std::min(value.find_first_not_of(kBlankCharacters), value.size()));
    value = value.substr(0, value.find_first_of(" \t\r\n,"));
    if (value.empty() || (node != text && local_name(node) != "tspan")) continue;
    try {
      return parse_length(value, whole, numbers);
    } catch (const Unusable& problem) {
      throw Unusable{problem.reason, quoted(name, value), true};
    }
  }
  return {};
}

}  // namespace

std::string shape_name(const pugi::xml_node& shape) {
  for (const pugi::xml_node& child : shape.children()) {
    if (local_name(child) != "title") continue;
    std::string title = characters(child);
    if (!title.empty()) return title;
  }
  std::string label = with_single_blanks(shape.attribute("inkscape:label").value());
  if (!label.empty()) return label;
  const std::string_view id = shape.attribute("id").value();
  return is_generated_id(id) ? std::string() : std::string(id);
}

bool is_generated_id(std::string_view id) {
  constexpr std::array<std::string_view, 22> kWords{
      "path",  "rect",  "rectangle", "circle", "ellipse", "line",         "polyline", "polygon",
      "g",     "group", "svg",       "svgid",  "use",     "shape",        "vector",   "object",
      "xmlid", "patch", "layer",     "image",  "element", "compound path"};
  constexpr std::size_t kLongId = 16;
  std::string lower(id);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (lower.starts_with("_x")) return true;
  const auto is_of = [](std::string_view text, const auto& is_one) {
    return std::all_of(text.begin(), text.end(), is_one);
  };
  if (lower.size() >= kLongId &&
      is_of(lower, [](char c) { return is_hexadecimal(c) || c == '-'; })) {
    return true;
  }
  constexpr std::string_view kNumbering = "0123456789-_. ";
  const std::size_t end = lower.find_last_not_of(kNumbering);
  const std::string_view word = std::string_view(lower).substr(0, end + 1);  // npos + 1 is 0
  return word.empty() || std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

std::optional<Model::Text> text_of(const pugi::xml_node& text, const SvgViewport& viewport,
                                   Numbers& numbers) {
  for (auto node = text; node; node = next_below(text, node)) {
    if (local_name(node) == "textPath") throw Unusable{"text on a path is not read", {}, true};
  }
  std::string said = characters(text);
  if (said.empty()) return {};
  Number x = first_length(text, "x", viewport.width, numbers);
  Number y = first_length(text, "y", viewport.height, numbers);
  return Model::Text{std::move(said), NumberPoint{std::move(x), std::move(y)}};
}

}  // namespace plumbline
