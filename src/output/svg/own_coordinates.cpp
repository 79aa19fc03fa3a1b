#include "output/svg/own_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::svg {
namespace {

constexpr double kAround = 0.02;                      // a part of the longer side
constexpr double kLeastWide = 500, kMostWide = 2000;  // what needs no scale
constexpr double kFarSizes = 16;                      // sizes from (0, 0)

constexpr double kMostScale = 1e15;  // where a viewBox is in drawing units

/// As a decimal, exactly.
std::string exact_decimal(double value) { return exact_text(rational_from(value)); }

}  // namespace

OwnCoordinates own_coordinates(const Extent& extent, bool y_up) {
  OwnCoordinates picture;
  const Box box = bounds(extent);
  const double longer = std::max(box.width(), box.height());
  const int exponent = std::ilogb(longer);
  Frame& frame = picture.frame;
  frame.y_up = y_up;
  if (longer < kLeastWide || longer > kMostWide) {
    frame.scale = std::ldexp(1, std::ilogb(kLeastWide) + 1 - exponent);
  }
  const double farthest = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  if (farthest > kFarSizes * longer) {
    const auto rounded = [&](double value) {
      return std::ldexp(std::floor(std::ldexp(value, -exponent)), exponent);
    };
    frame.origin = {rounded(box.low.x), rounded(box.low.y)};
  }
  picture.box = frame(box);
  picture.unit = std::max(picture.box.width(), picture.box.height()) / 1000;
  if (!extent.stray.empty()) {
    picture.about = fmt::format("{} segment{} far away, not shown", extent.stray.size(),
                                extent.stray.size() == 1 ? "" : "s");
  }
  return picture;
}

std::string open(const OwnCoordinates& picture, double foot) {
  const Frame& frame = picture.frame;
  const PointD origin{frame.origin.x,
                      frame.y_up && frame.origin.y != 0 ? -frame.origin.y : frame.origin.y};
  Box box = widened(picture.box, kAround);
  box.high.y += foot;
  const auto own = [&](const PointD& p) {
    return PointD{p.x / frame.scale + origin.x, p.y / frame.scale + origin.y};
  };
  std::string transform;
  if (origin.x != 0 || origin.y != 0) {
    transform = fmt::format("translate({} {})", exact_decimal(origin.x), exact_decimal(origin.y));
  }
  if (frame.scale != 1) transform += fmt::format("scale({})", exact_decimal(1 / frame.scale));
  // Viewers hold a viewBox in floats of 24 bits.
  const bool is_local =
      origin.x != 0 || origin.y != 0 || frame.scale > kMostScale || frame.scale < 1 / kMostScale;
  std::string svg = open_drawing(is_local ? box : Box{own(box.low), own(box.high)});
  if (!picture.about.empty()) svg += "<desc>" + picture.about + "</desc>\n";
  if (transform.empty()) return svg + "<g>\n";
  if (!is_local) return svg + "<g transform=\"" + transform + "\">\n";
  return svg + fmt::format(
                   "<desc>local coordinates; the drawing's own: {0}</desc>\n"
                   "<g data-plumbline-transform=\"{0}\">\n",
                   transform);
}

}  // namespace plumbline::svg
