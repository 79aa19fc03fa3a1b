#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "arrange/bucket/arithmetic.hpp"
#include "arrange/bucket/job.hpp"
#include "arrange/bucket/types.hpp"
#include "plumbline/geometry/point_list.hpp"

namespace plumbline::bucket {

/// Where integers are in the drawing: (c + (x, y)) / scale.
struct Frame {
  mpz_class x = 0, y = 0, scale = 1;
};

/// Lines with integer coordinates and what is asked about them, and about the points where they
/// cross. **Exact**, and without any division: of a crossing only its parameter along a line is
/// known, as a quotient of two cross products.
template <class Coordinate>
class ExactLines {
 public:
  using Difference = typename Arithmetic<Coordinate>::Difference;
  using Product = typename Arithmetic<Coordinate>::Product;
  static constexpr bool kWeighted = Arithmetic<Coordinate>::kWeighted;
  /// ax, ay, bx, by; and the positive integer that all of them are to be divided by, if weighted.
  using Line = std::array<Coordinate, kWeighted ? 5 : 4>;

  ExactLines() = default;
  ExactLines(std::vector<Line> lines, Frame frame)
      : lines_(std::move(lines)), frame_(std::move(frame)) {}

  std::size_t size() const { return lines_.size(); }
  const Line& operator[](LineId s) const { return lines_[s]; }
  /// Adds the line from one end to another, which lies on it or is the same point.
  /// Requires: `can_join`.
  LineId join(EndId a, EndId b);
  /// Whether the numbers of that line are not too long.
  bool can_join(EndId a, EndId b) const;
  /// Takes back the last ones that were joined.
  void resize(std::size_t size) { lines_.resize(size); }
  /// The lines in another order, without those left out.
  void reorder(const std::vector<LineId>& order, Job& job);
  bool is_point(LineId s) const {
    return lines_[s][0] == lines_[s][2] && lines_[s][1] == lines_[s][3];
  }
  /// Keys of the lines from begin to end: equal for lines on one supporting line, for equal points.
  void keys(std::size_t begin, std::size_t end, std::uint64_t* key) const;

  /// On which side of line s (positive: left) an end lies.
  int side(LineId s, EndId end) const { return sign(cross(s, end)); }
  /// Sign of the cross product of the directions of two lines.
  int compare_directions(LineId s, LineId o) const {
    return sign(Product(product(dx(s), dy(o)) - product(dy(s), dx(o))));
  }
  /// The parameter along s of its crossing with o, with an error of some roundings.
  double parameter(LineId s, LineId o) const;

  /// Lexicographic order of two ends.
  int compare(EndId p, EndId q) const {
    const int by_x = compare_x(p, q);
    return by_x != 0 ? by_x : compare_weighted(y(p), p, y(q), q);
  }
  int compare_x(EndId p, EndId q) const { return compare_weighted(x(p), p, x(q), q); }

  /// Order along s of its crossings with o and q.
  int compare_along(LineId s, LineId o, LineId q) const;
  /// The side of line c on which the crossing of s and o lies.
  int side_of_crossing(LineId c, LineId s, LineId o) const;
  /// Order of the x coordinates of the crossing of s and o, and of an end.
  int compare_x(LineId s, LineId o, EndId end) const;
  /// Order of the heights of s and o just right of an end's x. Requires: both are met there.
  int compare_heights(LineId s, LineId o, EndId end) const;

  /// The points, not in lowest terms.
  LongPoint point(EndId end) const;
  LongPoint crossing(LineId s, LineId o) const;

 protected:
  const Coordinate& x(EndId end) const { return lines_[line_of(end)][is_last(end) ? 2 : 0]; }
  const Coordinate& y(EndId end) const { return lines_[line_of(end)][is_last(end) ? 3 : 1]; }
  /// The parameter of the crossing with o along s as numerator / positive denominator.
  std::pair<Product, Product> fraction(LineId s, LineId o) const;

 private:
  Difference dx(LineId s) const { return Difference(lines_[s][2]) - lines_[s][0]; }
  Difference dy(LineId s) const { return Difference(lines_[s][3]) - lines_[s][1]; }
  /// A number times the weight of a line, or of an end's line.
  Difference weighted(const Coordinate& v, EndId end) const {
    if constexpr (kWeighted) {
      return product(v, lines_[line_of(end)][4]);
    } else {
      return v;
    }
  }
  int compare_weighted(const Coordinate& v, EndId p, const Coordinate& w, EndId q) const {
    if (have_one_weight(line_of(p), line_of(q))) return v < w ? -1 : (w < v ? 1 : 0);
    return sign(Difference(weighted(v, q) - weighted(w, p)));
  }
  Product weighted_product(const Difference& v, LineId s) const {
    if constexpr (kWeighted) {
      return product(v, Difference(lines_[s][4]));
    } else {
      return v;
    }
  }
  /// From the first end of s to an end, times both weights.
  Difference from_x(LineId s, EndId end) const {
    return weighted(x(end), first_end(s)) - weighted(lines_[s][0], end);
  }
  Difference from_y(LineId s, EndId end) const {
    return weighted(y(end), first_end(s)) - weighted(lines_[s][1], end);
  }
  /// Twice the area of the ends of s and an end, times a positive number that depends on the
  /// weights of s and of the end's line.
  Product cross(LineId s, EndId end) const {
    if (have_one_weight(s, line_of(end))) {
      return product(dx(s), Difference(Difference(y(end)) - lines_[s][1])) -
             product(dy(s), Difference(Difference(x(end)) - lines_[s][0]));
    }
    return product(dx(s), from_y(s, end)) - product(dy(s), from_x(s, end));
  }
  bool have_one_weight(LineId s, LineId o) const {
    if constexpr (kWeighted) {
      return lines_[s][4] == lines_[o][4];
    } else {
      return true;
    }
  }
  std::uint64_t key_of_rationals(LineId s) const;

  std::vector<Line> lines_;
  Frame frame_;
};

extern template class ExactLines<std::int32_t>;
extern template class ExactLines<Int128>;
extern template class ExactLines<Words>;
extern template class ExactLines<mpz_class>;

}  // namespace plumbline::bucket
