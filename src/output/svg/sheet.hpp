#pragma once

#include <string>

#include "output/svg/kit.hpp"
#include "plumbline/geometry.hpp"

/// A sheet of panels, two beside each other, that all show one drawing. All in pixels.
namespace plumbline::svg::sheet {

inline constexpr double kWidth = 1600, kMargin = 24;
inline constexpr double kPanelWidth = (kWidth - 3 * kMargin) / 2;

/// The root of a sheet, white.
std::string open(double width, double height);
/// "name: words", the name that of the drawing's first file; without a file the words.
std::string titled(const SegmentSet& input, const std::string& words);

/// What a panel shows: the box and some room for rings at its border.
Box content(const Box& drawing);
/// The height of panels that show such content.
double panel_height(const Box& content);
/// Where a panel draws the content, in thousandths of pixels.
Frame frame(const Box& content, const Box& panel, bool y_up);
/// The width of an edge's line: thinner where there are very many, so that they do not turn black.
double pen(const Box& panel, std::size_t edges);
/// The white ground of a panel.
std::string ground(const Box& panel);

}  // namespace plumbline::svg::sheet
