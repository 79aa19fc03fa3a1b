// A complex as a picture in the drawing's own coordinates, with a legend below it.

#include <fmt/format.h>

#include <algorithm>

#include "output/svg/own_coordinates.hpp"
#include "output/svg/panel.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr double kEdgePen = 1.2;                         // of lines, in units
constexpr double kLegendHeight = 50, kLegendWords = 16;  // heights, in units

/// In units, from (0, 0); marked, so that our reader does not take it for a part of the drawing.
std::string depth_legend(const svg::OwnCoordinates& picture, const FloatComplex& complex) {
  std::size_t deepest = 0, antennas = 0;
  for (const std::uint32_t depth : complex.face_depth) {
    deepest = std::max<std::size_t>(deepest, depth);
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    antennas += complex.is_antenna(EdgeId(e)) ? 1 : 0;
  }
  std::string svg;
  double x = 0;
  const auto words = [&](const std::string& text, double width) {
    svg += svg::text({x, 6}, kLegendWords, "", text);
    x += width;
  };
  if (deepest > 0) words("faces by depth", 130);
  for (std::size_t depth = 1; depth <= std::min(deepest, svg::kDepthColours.size()); ++depth) {
    svg += fmt::format("<rect x=\"{}\" y=\"-8\" width=\"18\" height=\"14\" fill=\"{}\"/>\n", x,
                       svg::kDepthColours[depth - 1]);
    x += 24;
    words(
        std::to_string(depth) + (depth == svg::kDepthColours.size() && depth < deepest ? "+" : ""),
        30);
  }
  if (antennas > 0) {
    x += 10;
    svg += fmt::format(
        "<path d=\"M{} 0h36\" stroke=\"{}\" stroke-width=\"1.5\" stroke-dasharray=\"4\"/>\n", x,
        svg::kInk);
    x += 44;
    words("antennas", 100);
  }
  if (!picture.about.empty()) words(picture.about, 0);
  if (svg.empty()) return {};
  return fmt::format(
             "<g data-plumbline=\"legend\" font-family=\"DejaVu Sans, Arial, sans-serif\" "
             "fill=\"{}\" "
             "transform=\"translate({} {})scale({})\">\n",
             svg::kInk, shortest_text(picture.box.low.x),
             shortest_text(picture.box.high.y + (kLegendHeight - kLegendWords) * picture.unit),
             shortest_text(picture.unit)) +
         svg + "</g>\n";
}

}  // namespace

std::string to_svg(const ExactComplex& complex, bool y_up) {
  const FloatComplex rounded = nearest(complex);
  const svg::OwnCoordinates picture = svg::own_coordinates(extent(rounded), y_up);
  const std::string below = depth_legend(picture, rounded);
  return svg::open(picture, below.empty() ? 0 : kLegendHeight * picture.unit) +
         svg::panel(rounded, picture.frame, kEdgePen * picture.unit, {}, svg::kNonScaling) + below +
         svg::kClose;
}

}  // namespace plumbline
