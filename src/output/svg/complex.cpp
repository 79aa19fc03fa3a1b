#include "output/svg/picture.hpp"
#include "plumbline/output.hpp"

namespace plumbline {

std::string to_svg(const ExactComplex& complex, bool y_up) {
  constexpr double kMargin = 0.02;
  FloatComplex rounded = nearest(complex);
  if (y_up) {
    for (PointD& p : rounded.vertices) p.y = 0.0 - p.y;
  }
  const svg::Box box = svg::widened(svg::bounds(rounded), kMargin);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + svg::coordinates(box.low) + ' ' +
         svg::coordinates({box.width(), box.height()}) + "\">\n" +
         svg::panel(rounded, svg::Frame(), svg::pen_width(box)) + "</svg>\n";
}

}  // namespace plumbline
