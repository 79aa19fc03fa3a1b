#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Counts the decimals of numbers to tell the unit in which a drawing was made: what the last
/// decimal is worth that one in a hundred numbers has, of those that are scaled alike, as most are.
/// Long numbers, which programs print, tell nothing, nor do the others where most are long;
/// decimals that are 5 where they are the last one come of halving and do not count.
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
    /// By number of decimals, without those that end in 5, which are in `halves`.
    std::array<std::size_t, Number::kMaxDigits + 1> count{}, halves{};
  };
  std::map<double, Decimals> by_scale_;
  std::size_t long_ = 0;
  double last_scale_ = 0;
  Decimals* last_ = nullptr;  ///< of that scale; few follow one another with different ones
};

}  // namespace plumbline
