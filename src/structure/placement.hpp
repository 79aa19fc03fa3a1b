#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// The rational rotations that stand for angles, each made once.
class Rotations {
 public:
  explicit Rotations(double bound) : bound_(bound) {}
  const ApproximateAffine& operator()(const Rational& degrees);

 private:
  double bound_;
  std::map<Rational, ApproximateAffine> known_;
};

/// The product of maps in which angles are added before rotations are replaced: with R(a) the
/// rotation by a degrees,
///     x -> frozen(sum of R(a) v over `shifts` + R(degrees) inner(x)).
/// A rotation goes to the left of a similarity, mirrored or not. What is left of any other map that
/// a rotation follows is frozen: its rotations are replaced, each sum by one for its own.
class Placement {
 public:
  explicit Placement(std::size_t dimension) : inner_(dimension) {}

  /// To apply first.
  void append(const Affine& map);
  void append(const Turn& turn, Rotations& rotations);
  /// Requires: `is_map(item)`.
  void append(const Struct::Item& item, Rotations& rotations);
  /// Without what moves the origin.
  Placement linear_part() const;

  /// The product.
  const Affine& map(Rotations& rotations);
  /// What tells this linear part from others.
  std::vector<Number> key() const;
  /// Throws: Error Limit for a number of more than kMaxMapBits.
  std::size_t checked_words() const;
  /// The angles of the rotations in it, in degrees.
  std::vector<Rational> angles() const;
  /// The rotation that was appended last; null where there is none.
  const Turn* last_turn() const { return turned_ ? turned_->last : nullptr; }

 private:
  struct Turned {
    std::optional<Affine> frozen;  ///< none: the identity
    std::vector<Rational> frozen_angles = {};
    std::map<Rational, std::array<Number, 2>> shifts = {};
    Rational degrees;  ///< -180 < degrees <= 180
    const Turn* last = nullptr;
  };

  Affine inner_;
  std::shared_ptr<const Turned> turned_;  ///< null where there are no rotations
  std::optional<Affine> map_;             ///< once it was asked for, where there are
};

}  // namespace plumbline
