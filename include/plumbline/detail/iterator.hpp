#pragma once

#include <compare>
#include <cstddef>
#include <iterator>

#include "plumbline/error.hpp"

namespace plumbline {

/// Random access to a sequence whose `operator[]` makes its items, by value.
template <class Sequence>
class ValueIterator {
 public:
  using iterator_category = std::input_iterator_tag;  // as it has no references to items
  using iterator_concept = std::random_access_iterator_tag;
  using value_type = typename Sequence::value_type;
  using difference_type = std::ptrdiff_t;
  using reference = value_type;
  using pointer = void;

  ValueIterator() = default;
  ValueIterator(const Sequence& sequence, difference_type position)
      : sequence_(&sequence), position_(position) {}

  value_type operator*() const { return (*this)[0]; }
  value_type operator[](difference_type n) const {
    return (*sequence_)[static_cast<std::size_t>(position_ + n)];
  }
  ValueIterator& operator++() { return *this += 1; }
  ValueIterator& operator--() { return *this += -1; }
  ValueIterator operator++(int) { return {*sequence_, position_++}; }
  ValueIterator operator--(int) { return {*sequence_, position_--}; }
  ValueIterator& operator+=(difference_type n) {
    position_ += n;
    return *this;
  }
  ValueIterator& operator-=(difference_type n) { return *this += -n; }
  friend ValueIterator operator+(ValueIterator i, difference_type n) { return i += n; }
  friend ValueIterator operator+(difference_type n, ValueIterator i) { return i += n; }
  friend ValueIterator operator-(ValueIterator i, difference_type n) { return i -= n; }
  friend difference_type operator-(const ValueIterator& i, const ValueIterator& j) {
    return i.position_ - j.position_;
  }
  friend bool operator==(const ValueIterator& i, const ValueIterator& j) {
    return i.position_ == j.position_;
  }
  friend auto operator<=>(const ValueIterator& i, const ValueIterator& j) {
    return i.position_ <=> j.position_;
  }

 private:
  const Sequence* sequence_ = nullptr;
  difference_type position_ = 0;
};

}  // namespace plumbline
