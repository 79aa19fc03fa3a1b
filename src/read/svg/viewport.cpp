#include "read/svg/viewport.hpp"

#include <array>
#include <string>
#include <utility>

#include "read/svg/style.hpp"

namespace plumbline {
namespace {

struct ViewBox {
  Rational x, y, width, height;
};

/// How a viewBox fills its viewport, from preserveAspectRatio.
struct Fit {
  bool stretch = false;       ///< "none": along x and y by different factors
  bool slice = false;         ///< filled, instead of fully visible
  Rational x{1, 2}, y{1, 2};  ///< the part of the free space on the near side
};

std::optional<ViewBox> view_box(const pugi::xml_node& element, Numbers& numbers) {
  const pugi::xml_attribute attribute = element.attribute("viewBox");
  if (!attribute) return std::nullopt;
  const std::string_view text = attribute.value();
  Scanner scanner(text);
  std::array<Rational, 4> values;
  try {
    scanner.skip_blanks();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) scanner.skip_separator();
      values[i] = numbers.take(scanner, "malformed viewBox").rational();
    }
    scanner.skip_blanks();
    if (!scanner.at_end()) throw Unusable{"malformed viewBox", {}};
    if (sgn(values[2]) < 0 || sgn(values[3]) < 0) throw Unusable{"negative extent of viewBox", {}};
    if (values[2] == 0 || values[3] == 0) throw Unusable{"viewBox without extent", {}};
  } catch (const Unusable& problem) {
    throw Unusable{problem.reason, quoted("viewBox", text)};
  }
  return ViewBox{values[0], values[1], values[2], values[3]};
}

/// The words of a text, up to four of them.
std::array<std::string_view, 4> words(std::string_view text) {
  std::array<std::string_view, 4> result;
  Scanner scanner(text);
  for (std::string_view& word : result) {
    scanner.skip_blanks();
    const std::size_t begin = scanner.position();
    while (!scanner.at_end() && !scanner.at_blank()) scanner.advance();
    word = scanner.since(begin);
  }
  return result;
}

/// The part that "Min", "Mid" or "Max" leaves on the near side.
std::optional<Rational> near_side(std::string_view word) {
  if (word == "Min") return Rational(0);
  if (word == "Mid") return Rational(1, 2);
  if (word == "Max") return Rational(1);
  return std::nullopt;
}

Fit fit_of(const pugi::xml_node& element) {
  constexpr std::size_t kAlignment = 8;  // characters of xMidYMid
  const pugi::xml_attribute attribute = element.attribute("preserveAspectRatio");
  Fit fit;
  if (!attribute) return fit;
  auto [align, scale, more, rest] = words(attribute.value());
  if (align == "defer") {
    align = scale;
    scale = more;
    more = rest;
  }
  fit.slice = scale == "slice";
  fit.stretch = align == "none";
  const bool known_scale = scale.empty() || scale == "meet" || fit.slice;
  if (known_scale && more.empty() && fit.stretch) return fit;
  if (known_scale && more.empty() && align.size() == kAlignment && align[0] == 'x' &&
      align[4] == 'Y') {
    const auto x = near_side(align.substr(1, 3));
    const auto y = near_side(align.substr(5, 3));
    if (x && y) {
      fit.x = *x;
      fit.y = *y;
      return fit;
    }
  }
  throw Unusable{"malformed preserveAspectRatio", quoted("preserveAspectRatio", attribute.value())};
}

/// A width or height: what `use` gives, or the attribute, or all of what is around; nothing where
/// that is unknown. Throws: Unusable for one that is negative or 0.
std::optional<Rational> extent(const pugi::xml_node& element, const char* name,
                               std::string_view given, const std::optional<Rational>& around,
                               Numbers& numbers) {
  const std::string_view text = given.empty() ? element.attribute(name).value() : given;
  if (text.empty() || text == "auto") return around;
  if (text == "100%" && !around) return std::nullopt;
  try {
    Rational value = parse_length(text, around, numbers).rational();
    if (sgn(value) > 0) return value;
    throw Unusable{std::string(sgn(value) < 0 ? "negative " : "zero ") + name, {}, sgn(value) == 0};
  } catch (const Unusable& problem) {
    throw Unusable{problem.reason, quoted(name, text), problem.harmless};
  }
}

/// Whether it hides what lies outside: not where it is as large as what is around it.
bool clips(const pugi::xml_node& element, const SvgExtents& given) {
  const auto is_smaller = [&element](const char* name, std::string_view text) {
    if (text.empty()) text = element.attribute(name).value();
    return !text.empty() && text != "auto" && text != "100%";
  };
  return presentation(element, "overflow") != "visible" &&
         (element.attribute("viewBox") || is_smaller("width", given.width) ||
          is_smaller("height", given.height));
}

/// The map that fits a viewBox into a viewport at the origin.
Affine fitted(const ViewBox& box, const Rational& width, const Rational& height, const Fit& fit) {
  Rational x_scale = width / box.width;
  Rational y_scale = height / box.height;
  if (!fit.stretch) {
    const bool take_x = (x_scale < y_scale) != fit.slice;
    (take_x ? y_scale : x_scale) = take_x ? x_scale : y_scale;
  }
  const Rational free_x = width - x_scale * box.width;
  const Rational free_y = height - y_scale * box.height;
  return compose(translation(fit.x * free_x - x_scale * box.x, fit.y * free_y - y_scale * box.y),
                 scaling(x_scale, y_scale));
}

}  // namespace

SvgViewport root_viewport(const pugi::xml_node& root, Numbers& numbers) {
  if (const auto box = view_box(root, numbers)) return {box->width, box->height};
  return {extent(root, "width", {}, std::nullopt, numbers),
          extent(root, "height", {}, std::nullopt, numbers)};
}

std::optional<LengthUnit> root_unit(const pugi::xml_node& root, Numbers& numbers) try {
  const auto physical = [&](const char* name) -> std::optional<Rational> {
    const std::string_view text = root.attribute(name).value();
    if (!is_physical_length(text)) return {};
    return parse_length(text, {}, numbers).rational();
  };
  const auto width = physical("width"), height = physical("height");
  if (!width && !height) return {};
  if ((width && sgn(*width) <= 0) || (height && sgn(*height) <= 0)) return {};
  Rational scale = 1;  // in 1/96 inch
  if (const auto box = view_box(root, numbers)) {
    const Fit fit = fit_of(root);
    const Rational x = width ? *width / box->width : *height / box->height;
    const Rational y = height ? *height / box->height : x;
    if (fit.stretch && x != y) return {};
    scale = (x < y) != fit.slice ? x : y;
  }
  return svg_unit(scale);
} catch (const Unusable&) {
  return {};
}

SvgPlacement place_viewport(const pugi::xml_node& element, const SvgExtents& given,
                            const SvgViewport& around, Numbers& numbers) {
  const auto box = view_box(element, numbers);
  const Fit fit = fit_of(element);
  const auto width = extent(element, "width", given.width, around.width, numbers);
  const auto height = extent(element, "height", given.height, around.height, numbers);
  SvgPlacement placement;
  placement.clips = clips(element, given);
  placement.map = translation(length_attribute(element, "x", around.width, numbers).rational(),
                              length_attribute(element, "y", around.height, numbers).rational());
  placement.inside = {width, height};
  if (!box) return placement;
  if (!width || !height) {
    throw Unusable{"viewBox in a viewport of unknown extent",
                   quoted("viewBox", element.attribute("viewBox").value())};
  }
  placement.map = compose(placement.map, fitted(*box, *width, *height, fit));
  placement.inside = {box->width, box->height};
  return placement;
}

}  // namespace plumbline
