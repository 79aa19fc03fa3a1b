#include <utility>

#include "plumbline/error.hpp"
#include "read/dxf/shapes.hpp"

namespace plumbline::dxf {
namespace {

std::size_t words(const Number& number) {
  if (number.is_decimal()) return 2;
  const Rational value = number.rational();
  return mpz_size(value.get_num_mpz_t()) + mpz_size(value.get_den_mpz_t());
}

}  // namespace

Chords Pen::bezier(std::span<const Point> points, std::span<const Rational> weights) {
  return spend(flattener_.bezier(points, weights));
}

Chords Pen::ellipse(const Ellipse& ellipse) { return spend(flattener_.ellipse(ellipse)); }

Chords Pen::arc(const EllipticArc& arc) { return spend(flattener_.arc(arc)); }

Chords Pen::spend(Chords chords) {
  for (const NumberPoint& p : chords.points) {
    const std::size_t count = words(p.x) + words(p.y);
    if (count > words_left_) {
      throw Error(ErrorCode::Limit, "the numbers of the curves take too much memory");
    }
    words_left_ -= count;
  }
  return chords;
}

}  // namespace plumbline::dxf
