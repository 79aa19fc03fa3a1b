#pragma once

#include <cstdint>

#include "arrange/bucket/wide.hpp"

namespace plumbline::bucket::prime_field {

/// The integers modulo the prime 2^61 - 1, in which a quotient of integers has one value, however
/// it is written: equal rationals have equal residues.
inline constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61U) - 1;

constexpr std::uint64_t reduced(std::uint64_t v) {
  v = (v & kPrime) + (v >> 61U);
  return v >= kPrime ? v - kPrime : v;
}
/// The residue of any 64-bit integer.
constexpr std::uint64_t residue(std::int64_t v) {
  const std::uint64_t r =
      reduced(v < 0 ? 0 - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v));
  return v < 0 && r != 0 ? kPrime - r : r;
}
constexpr std::uint64_t multiply(std::uint64_t a, std::uint64_t b) {
  const UInt128 p = static_cast<UInt128>(a) * b;
  return reduced((static_cast<std::uint64_t>(p) & kPrime) + static_cast<std::uint64_t>(p >> 61U));
}
constexpr std::uint64_t subtract(std::uint64_t a, std::uint64_t b) {
  return a >= b ? a - b : a + kPrime - b;
}
/// By Fermat's little theorem. Requires: a != 0.
constexpr std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t exponent = kPrime - 2; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = multiply(result, a);
    a = multiply(a, a);
  }
  return result;
}

/// A key that spreads two residues over 64 bits.
constexpr std::uint64_t key(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = (a ^ (b << 3U)) + 0x9E3779B97F4A7C15U * (b | 1U);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;  // splitmix64 (Steele, Lea, Flood 2014)
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// First parts of the keys of what has no slope.
inline constexpr std::uint64_t kVertical = kPrime, kPoint = kPrime + 1, kNoResidue = kPrime + 2;

}  // namespace plumbline::bucket::prime_field
