#include "read/svg_shape.hpp"

#include <utility>

namespace plumbline {
namespace {

std::string quoted(const char* name, std::string_view value) {
  return std::string(name) + "=\"" + std::string(value) + "\"";
}

Pieces line(const pugi::xml_node& element, Numbers& numbers) {
  const auto length = [&](const char* name) { return length_attribute(element, name, numbers); };
  NumberPoint a{length("x1"), length("y1")};
  NumberPoint b{length("x2"), length("y2")};
  Pieces pieces;
  pieces.segments.push_back(std::move(a), std::move(b));
  return pieces;
}

/// The corner radius in an attribute; nothing where it is missing or "auto".
std::optional<Number> radius(const pugi::xml_node& element, const char* name, Numbers& numbers) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute || std::string_view(attribute.value()) == "auto") return std::nullopt;
  return length_attribute(element, name, numbers);
}

void refuse_round_corners(const pugi::xml_node& element, Numbers& numbers) {
  const auto rx = radius(element, "rx", numbers);
  const auto ry = radius(element, "ry", numbers);
  // A radius that is not given is the other one; if either is 0 the corners are square.
  const Number zero;
  if (rx.value_or(ry.value_or(zero)) == zero || ry.value_or(rx.value_or(zero)) == zero) return;
  const char* name = rx ? "rx" : "ry";
  throw Unusable{"rounded corners are not understood yet",
                 quoted(name, element.attribute(name).value())};
}

/// The width or height of a rect: positive, or the rect is not drawn.
Number extent(const pugi::xml_node& element, const char* name, Numbers& numbers) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) throw Unusable{std::string("rect without ") + name, {}};
  Number value = length_attribute(element, name, numbers);
  if (sgn(value) > 0) return value;
  throw Unusable{std::string(sgn(value) < 0 ? "negative " : "zero ") + name,
                 quoted(name, attribute.value())};
}

Pieces rect(const pugi::xml_node& element, Numbers& numbers) {
  const Number x = length_attribute(element, "x", numbers);
  const Number y = length_attribute(element, "y", numbers);
  const Number right = x + extent(element, "width", numbers);
  const Number bottom = y + extent(element, "height", numbers);
  refuse_round_corners(element, numbers);
  const NumberPoint corners[] = {{x, y}, {right, y}, {right, bottom}, {x, bottom}};
  Pieces pieces;
  for (std::size_t i = 0; i < 4; ++i) {
    pieces.segments.push_back(corners[i], corners[(i + 1) % 4]);
  }
  return pieces;
}

}  // namespace

Number length_attribute(const pugi::xml_node& element, const char* name, Numbers& numbers) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return {};
  try {
    return parse_length(attribute.value(), numbers);
  } catch (const Unusable& problem) {
    throw Unusable{problem.reason, quoted(name, attribute.value())};
  }
}

Pieces parse_shape(const pugi::xml_node& element, std::string_view name, Numbers& numbers) {
  if (name == "line") return line(element, numbers);
  if (name == "rect") return rect(element, numbers);
  const char* data_name = name == "path" ? "d" : "points";
  const std::string_view data = element.attribute(data_name).value();
  Pieces pieces =
      name == "path" ? parse_path(data, numbers) : parse_points(data, name == "polygon", numbers);
  if (pieces.segments.empty() && pieces.refused.empty()) {
    throw Unusable{"draws nothing", quoted(data_name, data.substr(0, 100))};
  }
  return pieces;
}

}  // namespace plumbline
