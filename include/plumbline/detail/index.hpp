#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "plumbline/error.hpp"

namespace plumbline {

/// An index that can't be mistaken for an index into another array. Converts to std::size_t, so it
/// subscripts; made from a number only explicitly.
template <class Tag>
class Index {
 public:
  constexpr Index() = default;
  constexpr explicit Index(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr operator std::size_t() const { return value_; }
  constexpr bool valid() const { return value_ != kInvalid; }
  friend constexpr auto operator<=>(Index, Index) = default;
  friend constexpr bool operator==(Index, Index) = default;

 private:
  static constexpr std::uint32_t kInvalid = 0xffffffffU;
  std::uint32_t value_ = kInvalid;
};

}  // namespace plumbline
