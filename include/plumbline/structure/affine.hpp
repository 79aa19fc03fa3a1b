#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Largest dimension of maps and models.
inline constexpr std::size_t kMaxDimension = 64;

/// Exact affine map x -> A x + t of d-dimensional space, d >= 1. Entry (i, j) is that of A, entry
/// (i, d) that of t.
class Affine {
 public:
  /// The identity of the plane, of a space. Throws: Error BadInput for dimension 0, Limit
  /// beyond kMaxDimension.
  Affine() : Affine(2) {}
  explicit Affine(std::size_t dimension);
  /// (x, y) -> (a x + c y + e, b x + d y + f), the order of SVG's matrix(a b c d e f).
  Affine(Rational a, Rational b, Rational c, Rational d, Rational e, Rational f);

  std::size_t dimension() const { return dimension_; }
  /// Requires: row < dimension(), column <= dimension().
  const Number& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * (dimension_ + 1) + column];
  }
  Number& operator()(std::size_t row, std::size_t column) {
    return entries_[row * (dimension_ + 1) + column];
  }
  /// Row after row, d (d + 1) of them.
  std::span<const Number> entries() const { return entries_; }

  friend bool operator==(const Affine&, const Affine&) = default;

 private:
  std::size_t dimension_;
  std::vector<Number> entries_;
};

/// Requires: a map of the plane.
Point apply(const Affine& map, const Point& p);
/// The image of a point given by its coordinates. Requires: both spans hold map.dimension()
/// numbers and do not overlap.
void apply(const Affine& map, std::span<const Number> p, std::span<Number> image);
/// The map that applies `inner` first, then `outer`. Throws: Error BadInput for maps of different
/// dimensions.
Affine compose(const Affine& outer, const Affine& inner);
/// Throws: Error BadInput for a map that is not invertible. Cost: O(d^3) rational operations.
Affine inverse(const Affine& map);

/// Source of these and of the rotations: larstruct 2015, 1.3.
Affine translation(const std::vector<Rational>& by);
Affine translation(const Rational& dx, const Rational& dy);
Affine scaling(const std::vector<Rational>& factors);
Affine scaling(const Rational& sx, const Rational& sy);
/// x_row += factor * x_column. Requires: row != column, both < dimension.
Affine shear(std::size_t dimension, std::size_t row, std::size_t column, const Rational& factor);

/// The map of a space with k more dimensions that does the same and leaves the new, last
/// coordinates as they are; for k < 0 the map of the space without the last -k dimensions. Throws:
/// Error BadInput where nothing would be left, or where the dropped coordinates act on kept ones;
/// Limit beyond kMaxDimension.
Affine embed(const Affine& map, int k);

/// An affine map that stands for one whose entries are not rational. The bound is 0 where the map
/// is exactly the one asked for.
struct ApproximateAffine {
  Affine map;
  Rational bound;
};

/// Default bound on the angle by which `rotation` may deviate, in radians.
inline constexpr double kAngleBound = 1e-15;

/// Rotation about the origin by an angle in degrees (from +x towards +y). A multiple of 90 is
/// exact. Any other angle is replaced by a rational rotation (((1-t^2)/(1+t^2), 2t/(1+t^2)) with
/// rational t, so still an exact isometry) whose angle deviates by at most `bound` radians; the
/// bound is in the result. t is the first convergent of its continued fraction within the bound.
/// Throws: Error BadInput for a bound that is not positive and finite; the same below.
ApproximateAffine rotation(const Rational& degrees, double bound = kAngleBound);
/// The same by an angle in radians. Only 0 is exact in the sense of the bound in the result; but
/// where a multiple of a quarter turn lies within the bound it is taken.
ApproximateAffine rotation_in_radians(const Rational& radians, double bound = kAngleBound);
/// Rotation of space about the axis (x, y, z) by an angle that is the length of this vector, in
/// radians, counter-clockwise when the vector points to the viewer. The axis is exact; the angle is
/// replaced as above, by that of a rational quaternion; the map is an exact isometry. Degenerate:
/// the zero vector gives the identity, exactly. Source: larstruct 2015, 1.3 (Rodrigues), with the
/// sign of rotations about the coordinate axes put right.
ApproximateAffine rotation_in_space(const std::array<Rational, 3>& axis_angle,
                                    double bound = kAngleBound);
/// Skew along x (x += y tan(angle)), along y. Exact for angles with a rational tangent among the
/// multiples of 45 degrees; else the tangent is replaced by a rational one within `bound`
/// (absolute). Throws: Error BadInput for odd multiples of 90 degrees.
ApproximateAffine skew_x(const Rational& degrees, double bound = kAngleBound);
ApproximateAffine skew_y(const Rational& degrees, double bound = kAngleBound);

}  // namespace plumbline
