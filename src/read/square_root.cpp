#include "read/square_root.hpp"

#include "structure/continued_fraction.hpp"

namespace plumbline {

ApproximateRoot square_root(const Rational& square, const Rational& bound) {
  const mpz_class& p = square.get_num();
  const mpz_class& q = square.get_den();
  if (mpz_perfect_square_p(p.get_mpz_t()) != 0 && mpz_perfect_square_p(q.get_mpz_t()) != 0) {
    return {Rational(sqrt(p), sqrt(q)), 0};
  }
  // sqrt(p / q) = sqrt(p q) / q. With k more bits the integer root, rounded down, is off by less
  // than 1, hence relatively by less than 2^-k. A quarter of the bound does.
  const mpz_class inverse = bound.get_den() / bound.get_num() + 1;
  const mp_bitcnt_t k = mpz_sizeinbase(inverse.get_mpz_t(), 2) + 2;
  const mpz_class scaled = sqrt(mpz_class(p * q << 2 * k));
  Rational value(scaled, q << k);
  value.canonicalize();
  return {first_convergent(value, value * bound / 2), bound};
}

}  // namespace plumbline
