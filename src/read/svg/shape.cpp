#include "read/svg/shape.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "geometry/text_rounding.hpp"
#include "read/square_root.hpp"

namespace plumbline {
namespace {

/// Throws: Unusable for a value that is not positive.
Number positive(Number value, const pugi::xml_node& element, const char* name) {
  if (sgn(value) > 0) return value;
  throw Unusable{std::string(sgn(value) < 0 ? "negative " : "zero ") + name,
                 quoted(name, element.attribute(name).value()), sgn(value) == 0};
}

Ellipse ellipse_at(const Number& x, const Number& y, const Number& rx, const Number& ry) {
  return {{x.rational(), y.rational()}, {rx.rational(), 0}, {0, ry.rational()}};
}

/// Reads the attributes of one shape.
class ShapeReader {
 public:
  ShapeReader(const pugi::xml_node& element, const SvgViewport& viewport, const SvgTools& tools)
      : element_(element), viewport_(viewport), tools_(tools) {}

  Pieces line() const {
    SvgPen p = pen();
    p.move_to({x("x1"), y("y1")});
    p.line_to({x("x2"), y("y2")});
    return std::move(p).finish();
  }

  Pieces rect() const {
    const Number left = x("x");
    const Number top = y("y");
    const Number width = extent("width", viewport_.width);
    const Number height = extent("height", viewport_.height);
    auto rx = radius("rx", viewport_.width);
    auto ry = radius("ry", viewport_.height);
    // A radius that is not given is the other one; if either is 0 the corners are square.
    if (!rx) rx = ry;
    if (!ry) ry = rx;
    const Number right = left + width;
    const Number bottom = top + height;
    if (!rx || sgn(*rx) == 0 || sgn(*ry) == 0) return square_rect(left, top, right, bottom);
    const Number half = Number::decimal(5, 1);
    return rounded_rect(left, top, right, bottom, std::min(*rx, width * half),
                        std::min(*ry, height * half));
  }

  Pieces circle() const {
    std::optional<Replacement> replaced;
    const Number r = positive(circle_radius(replaced), element_, "r");
    Pieces pieces = whole({x("cx"), y("cy")}, {r, r}, "circle");
    if (replaced) pieces.replaced.push_back(std::move(*replaced));
    return pieces;
  }

  Pieces ellipse() const {
    const auto rx = radius("rx", viewport_.width);
    const auto ry = radius("ry", viewport_.height);
    if (!rx && !ry) throw Unusable{"ellipse without radii", {}, true};
    return whole({x("cx"), y("cy")},
                 {positive(rx ? *rx : *ry, element_, rx ? "rx" : "ry"),
                  positive(ry ? *ry : *rx, element_, ry ? "ry" : "rx")},
                 "ellipse");
  }

  Pieces path() const {
    if (attribute_is_none("d")) throw Unusable{"draws nothing", quoted("d", "none"), true};
    return not_empty(parse_path(element_.attribute("d").value(), tools_.numbers, pen()), "d");
  }

  Pieces points(bool closed) const {
    return not_empty(parse_points(element_.attribute("points").value(), closed, tools_.numbers),
                     "points");
  }

 private:
  bool attribute_is_none(const char* name) const {
    return std::string_view(element_.attribute(name).value()) == "none";
  }
  SvgPen pen() const { return {tools_.flattener, tools_.bound}; }
  Number x(const char* name) const { return length(name, viewport_.width); }
  Number y(const char* name) const { return length(name, viewport_.height); }
  Number length(const char* name, const std::optional<Rational>& whole) const {
    return length_attribute(element_, name, whole, tools_.numbers);
  }

  Number extent(const char* name, const std::optional<Rational>& whole) const {
    if (!element_.attribute(name)) throw Unusable{std::string("rect without ") + name, {}, true};
    return positive(length(name, whole), element_, name);
  }

  /// The radius in an attribute; nothing where it is missing or "auto". Throws: Unusable for a
  /// negative one.
  std::optional<Number> radius(const char* name, const std::optional<Rational>& whole) const {
    const pugi::xml_attribute attribute = element_.attribute(name);
    if (!attribute || std::string_view(attribute.value()) == "auto") return std::nullopt;
    Number value = length(name, whole);
    return sgn(value) == 0 ? value : positive(std::move(value), element_, name);
  }

  /// Percentages of a radius refer to sqrt((width^2 + height^2) / 2).
  Number circle_radius(std::optional<Replacement>& replaced) const {
    const std::string_view text = element_.attribute("r").value();
    const bool is_percentage = text.find('%') != text.npos;
    if (!is_percentage || !viewport_.width || !viewport_.height) return length("r", std::nullopt);
    const Rational& w = *viewport_.width;
    const Rational& h = *viewport_.height;
    const ApproximateRoot diagonal = square_root((w * w + h * h) / 2, rational_from(tools_.bound));
    if (diagonal.bound != 0) {
      replaced.emplace();
      replaced->what = quoted("r", text);
      replaced->bound = shortest_text(tools_.bound) + " of itself";
    }
    return length("r", diagonal.value);
  }

  Pieces whole(const NumberPoint& centre, const NumberPoint& radii, const char* what) const {
    SvgPen p = pen();
    EllipticArc arc;
    arc.ellipse = ellipse_at(centre.x, centre.y, radii.x, radii.y);
    arc.end = arc.start;
    p.move_to({centre.x + radii.x, centre.y});
    p.draw(arc, what, text_rounding(centre) + text_rounding(radii));
    return std::move(p).finish();
  }

  Pieces square_rect(const Number& left, const Number& top, const Number& right,
                     const Number& bottom) const {
    SvgPen p = pen();
    p.move_to({left, top});
    p.line_to({right, top});
    p.line_to({right, bottom});
    p.line_to({left, bottom});
    p.close();
    return std::move(p).finish();
  }

  /// From the left end of the upper side on, clockwise as seen with y downwards.
  Pieces rounded_rect(const Number& left, const Number& top, const Number& right,
                      const Number& bottom, const Number& rx, const Number& ry) const {
    SvgPen p = pen();
    const auto line_to = [&p](NumberPoint end) {
      if (!(end == p.position())) p.line_to(std::move(end));
    };
    const auto corner = [&](const Number& x, const Number& y, Point from, Point to) {
      const EllipticArc arc{ellipse_at(x, y, rx, ry), std::move(from), std::move(to), false};
      p.draw(arc, "rounded corner");
    };
    p.move_to({left + rx, top});
    line_to({right - rx, top});
    corner(right - rx, top + ry, {0, -1}, {1, 0});
    line_to({right, bottom - ry});
    corner(right - rx, bottom - ry, {1, 0}, {0, 1});
    line_to({left + rx, bottom});
    corner(left + rx, bottom - ry, {0, 1}, {-1, 0});
    line_to({left, top + ry});
    corner(left + rx, top + ry, {-1, 0}, {0, -1});
    return std::move(p).finish();
  }

  Pieces not_empty(Pieces pieces, const char* name) const {
    if (!pieces.segments.empty() || !pieces.refused.empty()) return pieces;
    constexpr std::size_t kShown = 100;
    const std::string_view data = element_.attribute(name).value();
    throw Unusable{"draws nothing", quoted(name, data.substr(0, kShown)), true};
  }

  const pugi::xml_node& element_;
  const SvgViewport& viewport_;
  const SvgTools& tools_;
};

}  // namespace

Pieces parse_shape(const pugi::xml_node& element, std::string_view name,
                   const SvgViewport& viewport, const SvgTools& tools) {
  const ShapeReader shape(element, viewport, tools);
  if (name == "line") return shape.line();
  if (name == "rect") return shape.rect();
  if (name == "circle") return shape.circle();
  if (name == "ellipse") return shape.ellipse();
  if (name == "path") return shape.path();
  return shape.points(name == "polygon");
}

}  // namespace plumbline
