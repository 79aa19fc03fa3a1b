#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumbline/error.hpp"

namespace plumbline {

/// A list of lists, stored flat.
template <class T>
class Lists {
 public:
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const T> operator[](std::size_t i) const {
    return {values_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  void reserve(std::size_t lists, std::size_t values) {
    begin_.reserve(lists + 1);
    values_.reserve(values);
  }
  template <class Range>
  void push_back(const Range& list) {
    values_.insert(values_.end(), list.begin(), list.end());
    ensure(values_.size() <= 0xffffffffU, "a list of lists holds less than 2^32 items");
    begin_.push_back(static_cast<std::uint32_t>(values_.size()));
  }
  /// All lists one after the other.
  std::span<const T> flat() const { return values_; }
  /// Where each list starts in `flat`, and where the last one ends: size() + 1 numbers.
  std::span<const std::uint32_t> starts() const { return begin_; }
  friend bool operator==(const Lists&, const Lists&) = default;

 private:
  std::vector<std::uint32_t> begin_{0};
  std::vector<T> values_;
};

}  // namespace plumbline
