#pragma once

#include "plumbline/number.hpp"

namespace plumbline {

/// A number that stands for a square root.
struct ApproximateRoot {
  Rational value;
  Rational bound;  ///< on |value - root| / root; 0 where the value is the root
};

/// The square root of a number >= 0: itself if it is rational, else a rational number within the
/// relative `bound`, as simple as a continued fraction makes it. Requires: bound > 0.
ApproximateRoot square_root(const Rational& square, const Rational& bound);

}  // namespace plumbline
