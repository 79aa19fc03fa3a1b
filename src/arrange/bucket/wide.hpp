#pragma once

#include <cstdint>

#include "number/wide.hpp"

namespace plumbline::bucket {

using wide::Int128, wide::UInt128, wide::UInt256, wide::magnitude, wide::multiply;

template <class Integer>
int sign(Integer v) {
  return (v > 0) - (v < 0);
}

/// A 256-bit integer in two's complement. Sums and differences that do not fit wrap around.
struct Int256 {
  Int128 high = 0;
  UInt128 low = 0;

  Int256() = default;
  Int256(Int128 v) : high(v < 0 ? -1 : 0), low(static_cast<UInt128>(v)) {}
  Int256(Int128 h, UInt128 l) : high(h), low(l) {}

  friend Int256 operator+(const Int256& a, const Int256& b) {
    const UInt128 sum = a.low + b.low;
    return wrapped(static_cast<UInt128>(a.high) + static_cast<UInt128>(b.high) + (sum < a.low),
                   sum);
  }
  friend Int256 operator-(const Int256& a, const Int256& b) {
    return wrapped(static_cast<UInt128>(a.high) - static_cast<UInt128>(b.high) - (a.low < b.low),
                   a.low - b.low);
  }
  Int256 operator-() const { return Int256() - *this; }
  friend bool operator==(const Int256&, const Int256&) = default;
  friend bool operator<(const Int256& a, const Int256& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
  friend bool operator>(const Int256& a, const Int256& b) { return b < a; }

 private:
  static Int256 wrapped(UInt128 h, UInt128 l) { return {static_cast<Int128>(h), l}; }
};

inline int sign(const Int256& v) { return v.high < 0 ? -1 : (v.high != 0 || v.low != 0 ? 1 : 0); }

inline UInt256 magnitude(const Int256& v) {
  const Int256 m = v.high < 0 ? -v : v;
  return {static_cast<UInt128>(m.high), m.low};
}

/// a b. Requires: both above -2^127.
inline Int256 product(Int128 a, Int128 b) {
  const UInt256 m = multiply(magnitude(a), magnitude(b));
  const Int256 p(static_cast<Int128>(m.high), m.low);
  return (a < 0) == (b < 0) ? p : -p;
}
/// a b. Requires: it fits.
constexpr std::int64_t product(std::int64_t a, std::int64_t b) { return a * b; }

/// Rounded to a nearby double: three roundings.
inline double to_double(const Int256& v) {
  const UInt256 m = magnitude(v);
  const double result = static_cast<double>(m.high) * 0x1p128 + static_cast<double>(m.low);
  return v.high < 0 ? -result : result;
}
inline double to_double(std::int64_t v) { return static_cast<double>(v); }

/// Sign of a b - c d. **Exact**; for integers every value but the least.
inline int compare_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  const Int128 left = static_cast<Int128>(a) * b, right = static_cast<Int128>(c) * d;
  return (left > right) - (left < right);
}

/// A 512-bit magnitude, from its highest part.
struct UInt512 {
  UInt256 high, low;
  friend bool operator==(const UInt512&, const UInt512&) = default;
  friend bool operator<(const UInt512& a, const UInt512& b) {
    return a.high == b.high ? a.low < b.low : a.high < b.high;
  }
};

inline UInt512 multiply(const UInt256& a, const UInt256& b) {
  const UInt256 low = multiply(a.low, b.low), high = multiply(a.high, b.high);
  const UInt256 mid1 = multiply(a.high, b.low), mid2 = multiply(a.low, b.high);
  const UInt128 s1 = low.high + mid1.low, s2 = s1 + mid2.low;
  const UInt128 carry1 = UInt128(s1 < low.high) + UInt128(s2 < s1);
  const UInt128 t1 = high.low + mid1.high, t2 = t1 + mid2.high, t3 = t2 + carry1;
  const UInt128 carry2 = UInt128(t1 < high.low) + UInt128(t2 < t1) + UInt128(t3 < t2);
  return {{high.high + carry2, t3}, {s2, low.low}};
}

inline int compare_products(const Int256& a, const Int256& b, const Int256& c, const Int256& d) {
  const int left = sign(a) * sign(b), right = sign(c) * sign(d);
  if (left != right) return left < right ? -1 : 1;
  if (left == 0) return 0;
  const UInt512 p = multiply(magnitude(a), magnitude(b)), q = multiply(magnitude(c), magnitude(d));
  if (p == q) return 0;
  return (p < q) == (left > 0) ? -1 : 1;
}

}  // namespace plumbline::bucket
