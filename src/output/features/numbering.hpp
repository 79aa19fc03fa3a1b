#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::features {

inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio
  std::uint64_t x = (a ^ (b * kOdd)) * kOdd;
  x ^= x >> 32U;
  x *= kOdd;
  return x ^ (x >> 29U);
}
inline std::uint64_t hash_of(const PointD& p) {  // + 0.0: -0 is 0
  return mixed(std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0));
}
inline std::uint64_t hash_of(const std::pair<std::uint32_t, std::uint32_t>& pair) {
  return mixed(pair.first, pair.second);
}

inline std::uint64_t hash_of(const std::string& text) { return std::hash<std::string>()(text); }

/// Numbers things from 0 on, equal ones alike, in the order in which they are met first.
template <class T>
class Numbering {
 public:
  Numbering() : slots_(kFirstSize, kFree) {}

  std::uint32_t number(const T& thing) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash_of(thing) & mask;
    while (slots_[at] != kFree && !(things_[slots_[at]] == thing)) at = (at + 1) & mask;
    if (slots_[at] != kFree) return slots_[at];
    const auto result = static_cast<std::uint32_t>(things_.size());
    slots_[at] = result;
    things_.push_back(thing);
    if (2 * things_.size() > slots_.size()) grow();
    return result;
  }
  const std::vector<T>& things() const { return things_; }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;
  static constexpr std::size_t kFirstSize = 1024;  // a power of two, as all sizes are

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < things_.size(); ++i) {
      std::size_t at = hash_of(things_[i]) & mask;
      while (slots_[at] != kFree) at = (at + 1) & mask;
      slots_[at] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<T> things_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace plumbline::features
