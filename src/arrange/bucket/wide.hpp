#pragma once

#include <cstdint>

namespace plumbline::bucket {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

template <class Integer>
int sign(Integer v) {
  return (v > 0) - (v < 0);
}

/// A 256-bit magnitude.
struct UInt256 {
  UInt128 high, low;
  friend bool operator==(const UInt256&, const UInt256&) = default;
  friend bool operator<(const UInt256& a, const UInt256& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
};

inline UInt256 multiply(UInt128 a, UInt128 b) {
  const std::uint64_t a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
  const std::uint64_t b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
  const UInt128 low = static_cast<UInt128>(a0) * b0;
  const UInt128 mid1 = static_cast<UInt128>(a1) * b0, mid2 = static_cast<UInt128>(a0) * b1;
  const UInt128 high = static_cast<UInt128>(a1) * b1;
  const UInt128 mid =
      (low >> 64) + static_cast<std::uint64_t>(mid1) + static_cast<std::uint64_t>(mid2);
  return {high + (mid1 >> 64) + (mid2 >> 64) + (mid >> 64),
          (mid << 64) | static_cast<std::uint64_t>(low)};
}

/// Sign of a b - c d. **Exact**; for 128-bit integers every value above -2^127.
inline int compare_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  const Int128 left = static_cast<Int128>(a) * b, right = static_cast<Int128>(c) * d;
  return (left > right) - (left < right);
}
inline int compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  const int left = sign(a) * sign(b), right = sign(c) * sign(d);
  if (left != right) return left < right ? -1 : 1;
  if (left == 0) return 0;
  const auto magnitude = [](Int128 v) { return static_cast<UInt128>(v < 0 ? -v : v); };
  const UInt256 p = multiply(magnitude(a), magnitude(b)), q = multiply(magnitude(c), magnitude(d));
  if (p == q) return 0;
  return (p < q) == (left > 0) ? -1 : 1;
}

}  // namespace plumbline::bucket
