#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "plumbline/geometry/extent.hpp"

namespace plumbline::svg {

/// The colours of every picture: one calm colour for the drawing, a strong second one for findings.
inline constexpr const char* kInk = "#1f2d3a";
inline constexpr const char* kMark = "#d55e00";
/// Faces of depth 1, 2, ...; deeper ones have the last colour. ColorBrewer's sequential "Blues",
/// safe for colour-blind readers.
inline constexpr std::array kDepthColours = {"#eaf2fa", "#d0e1f2", "#a9cfe5", "#7ab6d9", "#4f9bcb"};

/// An upright box of the plane.
struct Box {
  PointD low;
  PointD high;

  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  friend bool operator==(const Box&, const Box&) = default;
};

/// The least box around both boxes.
Box hull(const Box& a, const Box& b);
/// The box of the points. Degenerate: no point gives the unit square; a box of no extent (or below
/// 1e-290) is widened to one.
Box bounds(std::span<const PointD> points);
/// The box of what is not stray, with the same exceptions.
Box bounds(const Extent& extent);
/// The box, wider on each side by `fraction` of its longer side.
Box widened(const Box& box, double fraction);

/// Where a drawing stands in a picture: p is drawn at (p - origin) * scale + place (where y runs
/// upwards at place.y - (p.y - origin.y) * scale), rounded to
/// 1 / `steps` (0: not rounded). The default draws in the drawing's own coordinates.
struct Frame {
  PointD origin;
  PointD place;
  double scale = 1;
  double steps = 0;
  bool y_up = false;  ///< whether the drawing's y runs upwards; the picture's never does

  PointD operator()(const PointD& p) const;
  Box operator()(const Box& box) const;
};

/// The frame that shows `content` as large as possible in the middle of `panel`.
Frame fit(const Box& content, const Box& panel, bool y_up = false);

/// Paths are ended where they are longer, in bytes: viewers refuse or stall at many MB.
inline constexpr std::size_t kLargestPath = 500'000;

/// "x y" with the shortest decimals that read back as the same doubles.
std::string coordinates(const PointD& p);

/// "M...L...Z": a closed path through the points; "" for none.
std::string closed_path(std::span<const PointD> points);

// Elements, a line each. Attributes begin with a blank.

/// The root of a picture in the drawing's own coordinates.
std::string open_drawing(const Box& box);
std::string circle(const PointD& center, double radius, const std::string& attributes);
/// The words are escaped.
std::string text(const PointD& at, double size, const std::string& attributes,
                 std::string_view words);

/// The width of an edge's line that suits a picture of this box (in the same units).
double pen_width(const Box& box);

}  // namespace plumbline::svg
