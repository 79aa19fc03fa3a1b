#include "output/svg/kit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/text/escape.hpp"

namespace plumbline::svg {
namespace {

// A smaller drawing is drawn as a point: magnifying it to a panel would overflow.
constexpr double kLeastExtent = 1e-290;
// A picture of this many pens across reads well on a screen: thin lines at 1600 pixels.
constexpr double kPensAcross = 1000;

double rounded(double value, double steps) {
  return steps == 0 ? value : std::round(value * steps) / steps;
}

}  // namespace

Box hull(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

Box bounds(std::span<const PointD> points) {
  if (points.empty()) return {{0, 0}, {1, 1}};
  Box box{points[0], points[0]};
  for (const PointD& p : points) box = hull(box, {p, p});
  if (std::max(box.width(), box.height()) > kLeastExtent) return box;
  return {{box.low.x - 0.5, box.low.y - 0.5}, {box.high.x + 0.5, box.high.y + 0.5}};
}

Box bounds(const Extent& extent) {
  const std::array corners{extent.low, extent.high};
  return bounds(corners);
}

Box widened(const Box& box, double fraction) {
  const double margin = fraction * std::max(box.width(), box.height());
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

PointD Frame::operator()(const PointD& p) const {
  return {rounded((p.x - origin.x) * scale + place.x, steps),
          rounded((y_up ? origin.y - p.y : p.y - origin.y) * scale + place.y, steps)};
}

Box Frame::operator()(const Box& box) const {
  const PointD p = (*this)(box.low), q = (*this)(box.high);
  return y_up ? Box{{p.x, q.y}, {q.x, p.y}} : Box{p, q};
}

Frame fit(const Box& content, const Box& panel, bool y_up) {
  const double scale = std::min(panel.width() / content.width(), panel.height() / content.height());
  return {{content.low.x, y_up ? content.high.y : content.low.y},
          {panel.low.x + (panel.width() - content.width() * scale) / 2,
           panel.low.y + (panel.height() - content.height() * scale) / 2},
          scale,
          0,
          y_up};
}

std::string coordinates(const PointD& p) { return shortest_text(p.x) + ' ' + shortest_text(p.y); }

std::string closed_path(std::span<const PointD> points) {
  std::string path;
  for (const PointD& p : points) path += (path.empty() ? 'M' : 'L') + coordinates(p);
  return path.empty() ? path : path + 'Z';
}

std::string open_drawing(const Box& box) {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {}\">\n",
                     coordinates(box.low), coordinates({box.width(), box.height()}));
}

std::string circle(const PointD& center, double radius, const std::string& attributes) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", shortest_text(center.x),
                     shortest_text(center.y), shortest_text(radius), attributes);
}

std::string text(const PointD& at, double size, const std::string& attributes,
                 std::string_view words) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", shortest_text(at.x),
                     shortest_text(at.y), shortest_text(size), attributes, xml_text(words));
}

double pen_width(const Box& box) { return std::max(box.width(), box.height()) / kPensAcross; }

}  // namespace plumbline::svg
