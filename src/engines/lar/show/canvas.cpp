#include "engines/lar/show/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::svg {
namespace {

constexpr double kMargin = 20;
constexpr double kPen = 1;
constexpr double kSteps = 1000;  ///< coordinates have three decimals

double rounded(double value) { return std::round(value * kSteps) / kSteps; }

}  // namespace

std::string colour(std::size_t number) {
  constexpr double kGoldenRatio = 0.6180339887498949, kDarkest = 60, kRange = 150;
  const double hue = std::fmod(static_cast<double>(number % 1'000'000) * kGoldenRatio, 1.0);
  const auto channel = [&](double phase) {
    const double distance = std::abs(std::fmod(hue + phase, 1.0) * 6 - 3) - 1;
    return static_cast<unsigned>(kDarkest + kRange * std::clamp(distance, 0.0, 1.0));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(2.0 / 3), channel(1.0 / 3));
}

void Canvas::show(const Box& box) {
  box_ = box;
  frame_ = fit(box, {{kMargin, kMargin}, {kSide - kMargin, kSide - kMargin}}, y_up_);
  frame_.steps = kSteps;
}

void Canvas::line(const PointD& a, const PointD& b, const std::string& attributes) {
  elements_ += fmt::format("<path d=\"M{}L{}\"{}/>\n", coordinates(frame_(a)),
                           coordinates(frame_(b)), attributes);
}

void Canvas::paths(std::span<const std::vector<PointD>> paths, const std::string& attributes) {
  std::string data;
  for (std::vector<PointD> path : paths) {
    for (PointD& p : path) p = frame_(p);
    data += closed_path(path);
  }
  elements_ += fmt::format("<path{} fill-rule=\"evenodd\" d=\"{}\"/>\n", attributes, data);
}

void Canvas::circle(const PointD& center, double radius, const std::string& attributes) {
  elements_ += svg::circle(frame_(center), radius, attributes);
}

void Canvas::text(const PointD& at, std::size_t number, double size, const char* ink) {
  elements_ += svg::text(frame_(at), rounded(size), fmt::format(" fill=\"{}\"", ink),
                         std::to_string(number));
}

void Canvas::open_group(const std::string& attributes) { elements_ += "<g" + attributes + ">\n"; }
void Canvas::close_group() { elements_ += "</g>\n"; }

double Canvas::length(double drawn) const { return rounded(drawn * frame_.scale); }

std::string Canvas::svg() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {0}\" fill=\"none\" "
             "stroke=\"{1}\" stroke-width=\"{2}\" stroke-linecap=\"round\">\n",
             kSide, kInk, kPen) +
         elements_ + "</svg>\n";
}

}  // namespace plumbline::svg
