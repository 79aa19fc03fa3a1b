#include "structure/continued_fraction.hpp"

#include <cmath>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {

mpz_class floor(const Rational& x) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

Rational first_convergent(const Rational& x, const Rational& bound) {
  mpz_class numerator = 1, denominator = 0, last_numerator = 0, last_denominator = 1;
  Rational rest = x;
  while (true) {  // ends at x itself at the latest
    const mpz_class whole = floor(rest);
    last_numerator += whole * numerator;
    last_denominator += whole * denominator;
    std::swap(numerator, last_numerator);
    std::swap(denominator, last_denominator);
    const Rational convergent(numerator, denominator);  // in lowest terms, as all convergents are
    if (abs(convergent - x) <= bound) return convergent;
    rest = 1 / (rest - whole);
  }
}

Rational checked_bound(double bound) {
  if (!std::isfinite(bound) || bound <= 0) {
    throw Error(ErrorCode::BadInput, "bound is not positive and finite", {}, shortest_text(bound));
  }
  return rational_from(bound);
}

}  // namespace plumbline
