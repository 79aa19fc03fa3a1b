#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "arrange/bucket/wide.hpp"
#include "number/fixed_integer.hpp"

namespace plumbline::bucket {

/// The numbers that predicates of lines need: differences of coordinates, and products of two of
/// these with sums of them; and of what crossings are products of. Where numbers are weighted, each
/// line has a denominator of its own.
template <class Coordinate>
struct Arithmetic;
/// Of 30 bits: differences need 31, products and sums of them 63, with the sign 64.
template <>
struct Arithmetic<std::int32_t> {
  using Difference = std::int64_t;
  using Product = std::int64_t;
  using Factor = FixedInteger<4>;
  static constexpr int kBits = 30;
  static constexpr bool kWeighted = false;
};
/// Of 124 bits: differences need 125, products and sums of them 252, with the sign 253.
template <>
struct Arithmetic<Int128> {
  using Difference = Int128;
  using Product = Int256;
  using Factor = FixedInteger<4>;
  static constexpr int kBits = 124;
  static constexpr bool kWeighted = false;
};
/// Of 255 bits, as weights: differences need 256, products with weights 510, differences of these
/// 511, and products and sums of all these at most 769.
using Words = FixedInteger<4>;
template <>
struct Arithmetic<Words> {
  using Difference = FixedInteger<8>;
  using Product = FixedInteger<16>;
  using Factor = Product;
  static constexpr int kBits = 255;
  static constexpr bool kWeighted = true;
};
template <>
struct Arithmetic<mpz_class> {
  using Difference = mpz_class;
  using Product = mpz_class;
  using Factor = mpz_class;
  static constexpr bool kWeighted = true;
};

inline int sign(const mpz_class& v) { return sgn(v); }
inline mpz_class product(const mpz_class& a, const mpz_class& b) { return a * b; }
inline int compare_products(const mpz_class& a, const mpz_class& b, const mpz_class& c,
                            const mpz_class& d) {
  return cmp(a * b, c * d);
}

inline mpz_class to_mpz(Int128 v) { return to_mpz(FixedInteger<2>(v)); }
inline mpz_class to_mpz(const Int256& v) {
  return to_mpz(FixedInteger<4>(magnitude(v), sign(v) < 0));
}
inline const mpz_class& to_mpz(const mpz_class& v) { return v; }
/// Requires: |v| < 2^255.
inline Int256 to_int256(const mpz_class& v) {
  const auto limb = [&](int i) { return UInt128{mpz_getlimbn(v.get_mpz_t(), i)}; };
  const Int256 m(static_cast<Int128>(limb(3) << 64U | limb(2)), limb(1) << 64U | limb(0));
  return sgn(v) < 0 ? -m : m;
}

}  // namespace plumbline::bucket
