#pragma once

#include "plumbline/number.hpp"

namespace plumbline {

mpz_class floor(const Rational& x);

/// The first convergent of the continued fraction of x that is no further from it than `bound`.
Rational first_convergent(const Rational& x, const Rational& bound);

/// The bound on an angle, a double that a caller gave. Throws: Error BadInput where it is not
/// positive and finite.
Rational checked_bound(double bound);

}  // namespace plumbline
