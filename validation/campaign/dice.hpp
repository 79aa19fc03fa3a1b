#pragma once

#include <cstdint>

namespace plumbline::campaign {

/// A stream of random numbers that starts at once and is the same everywhere: splitmix64 (Steele,
/// Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t roll() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// From 0 to count - 1.
  int pick(std::size_t count) { return static_cast<int>(roll() % count); }
  int between(int low, int high) { return low + pick(static_cast<std::size_t>(high - low + 1)); }
  bool one_in(std::size_t count) { return pick(count) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace plumbline::campaign
