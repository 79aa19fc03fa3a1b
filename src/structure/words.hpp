#pragma once

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"

namespace plumbline {

/// Size of a number in 64-bit words; of a decimal one word each for mantissa and denominator.
inline std::size_t words(const Number& x) {
  if (x.is_decimal()) return x.mantissa() == 0 ? 1 : 2;
  const Rational& value = x.held_rational();
  return mpz_size(value.get_num_mpz_t()) + mpz_size(value.get_den_mpz_t());
}

/// Size of a map's numbers. Throws: Error Limit for one of more than kMaxMapBits.
std::size_t checked_words(const Affine& map);

/// What a result may still grow by.
class WordBudget {
 public:
  explicit WordBudget(std::size_t words) : left_(words) {}

  void spend(std::size_t words) {
    if (words > left_) {
      throw Error(ErrorCode::Limit, "the structure is too large when all references are followed");
    }
    left_ -= words;
  }

 private:
  std::size_t left_;
};

/// How many segments, or cells, a result may still get.
class CountBudget {
 public:
  CountBudget(std::size_t most, const char* what) : most_(most), left_(most), what_(what) {}

  void spend(std::size_t count) {
    if (count > left_) {
      throw Error(ErrorCode::Limit, "more than " + std::to_string(most_) + " " + what_);
    }
    left_ -= count;
  }

 private:
  std::size_t most_;
  std::size_t left_;
  const char* what_;
};

}  // namespace plumbline
