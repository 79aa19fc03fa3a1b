#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/svg/kit.hpp"

namespace plumbline::svg {

/// A strong colour; consecutive numbers are a golden angle apart on the colour wheel.
std::string colour(std::size_t number);

/// A square SVG picture that grows element by element. Coordinates are the drawing's; they are
/// rounded to three decimals of the picture's units. Attributes begin with a blank.
class Canvas {
 public:
  static constexpr double kSide = 1000;  ///< of the picture

  /// Shows the box as large as fits.
  Canvas(const Box& box, bool y_up) : y_up_(y_up) { show(box); }

  const Box& box() const { return box_; }
  /// Shows another box in what comes.
  void show(const Box& box);

  void line(const PointD& a, const PointD& b, const std::string& attributes = {});
  /// Closed paths, filled together by parity.
  void paths(std::span<const std::vector<PointD>> paths, const std::string& attributes);
  void circle(const PointD& center, double radius, const std::string& attributes);
  void text(const PointD& at, std::size_t number, double size, const char* ink);
  void open_group(const std::string& attributes);
  void close_group();

  /// A length of the drawing in the picture.
  double length(double drawn) const;
  std::string svg() const;

 private:
  Box box_;
  Frame frame_;
  bool y_up_;
  std::string elements_;
};

}  // namespace plumbline::svg
