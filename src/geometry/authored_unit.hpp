#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Counts the decimals of numbers to tell the unit in which a drawing was made: what the last
/// decimal is worth that one in a hundred numbers has, of those that are scaled alike, as most are.
/// Long numbers, which programs print, tell nothing.
class AuthoredUnit {
 public:
  AuthoredUnit() = default;
  AuthoredUnit(const AuthoredUnit&) = delete;
  AuthoredUnit& operator=(const AuthoredUnit&) = delete;

  /// A number of the file that is drawn so many times as large.
  void add(const Number& number, double scale);
  /// **Rounded**. 0 where it is not known.
  double unit() const;

 private:
  struct Decimals {
    std::size_t all = 0;
    std::array<std::size_t, Number::kMaxDigits + 1> count{};  ///< by number of decimals
  };
  std::map<double, Decimals> by_scale_;
  double last_scale_ = 0;
  Decimals* last_ = nullptr;  ///< of that scale; few follow one another with different ones
};

}  // namespace plumbline
