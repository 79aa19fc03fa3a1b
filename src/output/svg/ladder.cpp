// The tolerance ladder as a picture: three step plots over the logarithm of the radius, each with
// an axis of its own, since vertices, edges and faces differ by more than their steps do.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "output/svg/sheet.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

// All in pixels.
constexpr double kWidth = 900, kLeft = 90, kRight = 30, kTop = 70, kBottom = 60;
constexpr double kPlotHeight = 150, kPlotGap = 24;
constexpr double kAxisWidth = kWidth - kLeft - kRight;
constexpr double kHeight = kTop + 3 * kPlotHeight + 2 * kPlotGap + kBottom;
constexpr const char* kGrid = "#d8dee4";
constexpr const char* kRightBand = "#dff1e3";
// Least width of the axis, in decades, and the room before the first and behind the last step.
constexpr double kLeastDecades = 1, kRoom = 0.08;

/// Of the logarithms of radii.
struct Axis {
  double low, high;

  double operator()(double logarithm) const {
    return kLeft + kAxisWidth * (std::clamp(logarithm, low, high) - low) / (high - low);
  }
};

double logarithm(const LadderStep& step) {
  return std::log10(
      std::max(nearest_sqrt(step.squared_radius), std::numeric_limits<double>::denorm_min()));
}

Axis axis_of(const ToleranceLadder& ladder) {
  if (ladder.steps.empty()) return {-1, 1};
  const double first = logarithm(ladder.steps.front()), last = logarithm(ladder.steps.back());
  const double room = std::max((last - first) * kRoom, kLeastDecades / 2);
  return {first - room, last + room};
}

std::string text(double x, double y, const char* anchor, double size, const std::string& words) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, size,
      anchor, words);
}

std::string line(double x, double y, double to_x, double to_y, const char* colour) {
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"1\"/>\n", x, y, to_x,
      to_y, colour);
}

/// Vertical lines at decades, or at 1, 2 and 5 times them where there are few, with their radii.
std::string radius_ticks(const Axis& axis) {
  constexpr double kMostLabels = 12, kFewDecades = 4;
  std::string svg;
  const double decades = axis.high - axis.low;
  const double step = std::ceil(decades / kMostLabels);
  for (double decade = std::floor(axis.low); decade <= axis.high; ++decade) {
    for (const double multiple : {1.0, 2.0, 5.0}) {
      if (multiple > 1 && decades > kFewDecades) continue;
      if (multiple == 1 && std::fmod(decade, step) != 0) continue;
      const double at = decade + std::log10(multiple);
      if (at < axis.low || at > axis.high) continue;
      svg += line(axis(at), kTop, axis(at), kHeight - kBottom, kGrid);
      svg += text(axis(at), kHeight - kBottom + 18, "middle", 12,
                  fmt::format("{:g}", multiple * std::pow(10, decade)));
    }
  }
  return svg;
}

/// A distance of ticks that gives about four of them: 1, 2 or 5 times a power of ten.
double tick_distance(double range) {
  constexpr double kTicks = 4;
  const double power = std::pow(10, std::floor(std::log10(std::max(range / kTicks, 1.0))));
  for (const double multiple : {1.0, 2.0, 5.0}) {
    if (power * multiple * kTicks >= range) return power * multiple;
  }
  return 10 * power;
}

std::string plot(const ToleranceLadder& ladder, const Axis& axis, const char* name,
                 const char* colour, double top, std::size_t before,
                 std::size_t LadderStep::*member) {
  std::size_t least = before, most = before;
  for (const LadderStep& step : ladder.steps) {
    least = std::min(least, step.*member);
    most = std::max(most, step.*member);
  }
  const double low = static_cast<double>(least),
               range = std::max(static_cast<double>(most) - low, 1.0);
  const auto y = [&](double count) { return top + kPlotHeight * (1 - (count - low) / range); };
  std::string svg;
  const double distance = tick_distance(range);
  for (double tick = std::ceil(low / distance) * distance; tick <= low + range; tick += distance) {
    svg += line(kLeft, y(tick), kWidth - kRight, y(tick), kGrid);
    svg += text(kLeft - 8, y(tick) + 4, "end", 12, fmt::format("{:.0f}", tick));
  }
  svg += text(kLeft + 6, top - 6, "start", 14, name);
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}", kLeft, y(static_cast<double>(before)));
  for (const LadderStep& step : ladder.steps) {
    svg +=
        fmt::format("H{:.1f}V{:.1f}", axis(logarithm(step)), y(static_cast<double>(step.*member)));
  }
  svg += fmt::format("H{:.1f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                     ladder.is_complete ? kWidth - kRight : axis(axis.high), colour);
  return svg;
}

std::string band(const Axis& axis, const RightRadii& radii) {
  if (radii.empty()) return "";
  const auto x = [&](double radius) { return axis(radius > 0 ? std::log10(radius) : axis.low); };
  const double from = x(radii.least), to = x(radii.largest);
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"><title>float LAR is "
      "right with every radius tried from {} to {}</title></rect>\n",
      from, kTop, std::max(to - from, 1.0), kHeight - kBottom - kTop, kRightBand,
      shortest_text(radii.least), shortest_text(radii.largest));
}

}  // namespace

std::string to_svg(const ToleranceLadder& ladder, const std::optional<RightRadii>& radii) {
  const Axis axis = axis_of(ladder);
  std::string svg = svg::sheet::open(kWidth, kHeight);
  if (radii) svg += band(axis, *radii);
  svg += radius_ticks(axis);
  svg += text(kLeft, 28, "start", 18,
              ladder.is_complete
                  ? "tolerance ladder"
                  : fmt::format("tolerance ladder, the first {} steps", ladder.steps.size()));
  if (radii) {
    svg += text(kWidth - kRight, 28, "end", 13,
                radii->empty() ? "no radius tried is right for float LAR"
                               : fmt::format("green: float LAR right, {:.4g} to {:.4g}",
                                             radii->least, radii->largest));
  }
  const auto top = [](int i) { return kTop + i * (kPlotHeight + kPlotGap); };
  svg += plot(ladder, axis, "vertices", svg::kInk, top(0), ladder.vertices, &LadderStep::vertices);
  svg += plot(ladder, axis, "edges", "#4f9bcb", top(1), ladder.edges, &LadderStep::edges);
  svg += plot(ladder, axis, "faces", svg::kMark, top(2), ladder.faces, &LadderStep::faces);
  svg += text(kLeft + kAxisWidth / 2, kHeight - 16, "middle", 13, "radius (drawing units)");
  return svg + "</svg>\n";
}

}  // namespace plumbline
