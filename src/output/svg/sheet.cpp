#include "output/svg/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plumbline::svg::sheet {

std::string open(double width, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"DejaVu Sans, Arial, sans-serif\" "
      "fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
      width, height, kInk);
}

std::string titled(const SegmentSet& input, const std::string& words) {
  const bool has_stray = !extent(input).stray.empty();
  const std::string all = has_stray ? words + "; what lies far away is not shown" : words;
  if (input.files.empty()) return all;
  return std::filesystem::path(input.files.front()).filename().string() + ": " + all;
}

Box content(const Box& drawing) {
  constexpr double kRoom = 0.05;  // a part of the longer side
  return widened(drawing, kRoom);
}

double panel_height(const Box& content) {
  constexpr double kLeast = 240, kGreatest = 1200;
  return std::clamp(kPanelWidth * content.height() / content.width(), kLeast, kGreatest);
}

Frame frame(const Box& content, const Box& panel, bool y_up) {
  constexpr double kStepsPerPixel = 1000;
  Frame frame = fit(content, panel, y_up);
  frame.steps = kStepsPerPixel;
  return frame;
}

double pen(const Box& panel, std::size_t edges) {
  constexpr double kEdgesAtFullPen = 3000, kThinnest = 0.2;
  const double crowd = std::max(static_cast<double>(edges), 1.0);
  return pen_width(panel) * std::clamp(std::sqrt(kEdgesAtFullPen / crowd), kThinnest, 1.0);
}

std::string ground(const Box& panel) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\" "
      "stroke=\"#c9d1d9\"/>\n",
      panel.low.x, panel.low.y, panel.width(), panel.height());
}

}  // namespace plumbline::svg::sheet
