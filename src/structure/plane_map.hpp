#pragma once

#include <array>

#include "plumbline/structure/affine.hpp"

namespace plumbline {

/// A map of the plane, ready for many points. Where its entries are not decimals they are held as
/// integers over one denominator per row, so that the image of a point of decimals costs one
/// reduction to lowest terms per coordinate.
class PlaneMap {
 public:
  /// Keeps a reference to the map. Requires: of dimension 2.
  explicit PlaneMap(const Affine& map);

  NumberPoint operator()(const NumberPoint& p) const;

 private:
  struct Row {
    std::array<mpz_class, 3> numerators;
    mpz_class denominator;
  };

  Number image(const Row& row, const NumberPoint& p) const;

  const Affine& map_;
  bool is_identity_;
  bool is_decimal_;
  std::array<Row, 2> rows_;  ///< unless is_decimal_
  mutable mpz_class x_, y_, unit_;
};

}  // namespace plumbline
