// Roots that are rational are added exactly; the others are enclosed in ever closer bounds.

#include "diagnose/roots.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace plumbline::diagnose_steps {
namespace {

constexpr unsigned long kFirstBits = 128;

std::optional<Rational> rational_root(const Rational& square) {
  if (mpz_perfect_square_p(square.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(square.get_den_mpz_t()) == 0) {
    return std::nullopt;
  }
  return Rational(sqrt(square.get_num()), sqrt(square.get_den()));
}

/// The largest multiple of 2^-bits that is not greater than the root.
mpz_class scaled_root(const Rational& square, unsigned long bits) {
  return sqrt(mpz_class((square.get_num() << (2 * bits)) / square.get_den()));
}

/// The sum of the roots without their fractions of 2^-bits: too small by less than one such unit a
/// root.
Rational lower_bound(const std::vector<Rational>& squares, unsigned long bits) {
  mpz_class sum = 0;
  for (const Rational& square : squares) sum += scaled_root(square, bits);
  Rational result(sum);
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), bits);
  return result;
}

}  // namespace

int Roots::compare(const Rational& value) const {
  Rational rest = value;
  std::vector<Rational> irrational;
  for (const Rational& square : squares_) {
    if (const auto root = rational_root(square)) {
      rest -= *root;
    } else {
      irrational.push_back(square);
    }
  }
  if (irrational.empty()) return -sgn(rest);
  if (sgn(rest) <= 0) return 1;
  for (unsigned long bits = kFirstBits;; bits *= 2) {
    const Rational low = lower_bound(irrational, bits);
    if (low >= rest) return 1;  // the sum is greater than its lower bound
    Rational slack(static_cast<unsigned long>(irrational.size()));
    mpq_div_2exp(slack.get_mpq_t(), slack.get_mpq_t(), bits);
    if (low + slack <= rest) return -1;
  }
}

double Roots::rounded() const {
  double sum = 0;
  for (const Rational& square : squares_) sum += nearest_sqrt(square);
  return sum;
}

double Roots::rounded_up() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // With this many bits a sum of double's size is known far better than to a double's precision.
  double result =
      squares_.size() == 1 ? rounded() : nearest_double(lower_bound(squares_, 8 * kFirstBits));
  while (compare(rational_from(result)) > 0) result = std::nextafter(result, kInfinity);
  while (result > 0 && compare(rational_from(std::nextafter(result, 0.0))) <= 0) {
    result = std::nextafter(result, 0.0);
  }
  return result;
}

double root_rounded_up(const Rational& square) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto is_enough = [&](double root) {
    const Rational value = rational_from(root);
    return value * value >= square;
  };
  double result = nearest_sqrt(square);
  while (!is_enough(result)) result = std::nextafter(result, kInfinity);
  while (result > 0 && is_enough(std::nextafter(result, 0.0))) result = std::nextafter(result, 0.0);
  return result;
}

}  // namespace plumbline::diagnose_steps
