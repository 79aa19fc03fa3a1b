#include "output/svg/picture.hpp"
#include "plumbline/write.hpp"

namespace plumbline {

std::string to_svg(const ExactComplex& complex, bool y_up) {
  constexpr double kMargin = 0.02;
  FloatComplex rounded = nearest(complex);
  if (y_up) {
    for (PointD& p : rounded.vertices) p.y = 0.0 - p.y;
  }
  const picture::Box box = picture::widened(picture::bounds(rounded), kMargin);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + picture::coordinates(box.low) +
         ' ' + picture::coordinates({box.width(), box.height()}) + "\">\n" +
         picture::panel(rounded, picture::Frame(), picture::pen_width(box)) + "</svg>\n";
}

}  // namespace plumbline
