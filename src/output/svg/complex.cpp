#include "output/svg/panel.hpp"
#include "plumbline/output.hpp"

namespace plumbline {

std::string to_svg(const ExactComplex& complex, bool y_up) {
  constexpr double kMargin = 0.02;
  const FloatComplex rounded = nearest(complex);
  svg::Frame frame;
  frame.y_up = y_up;
  const svg::Box box = svg::widened(frame(svg::bounds(rounded.vertices)), kMargin);
  return svg::open_drawing(box) + svg::panel(rounded, frame, svg::pen_width(box)) + "</svg>\n";
}

}  // namespace plumbline
