#pragma once

#include <vector>

#include "plumbline/number.hpp"

namespace plumbline::diagnose_steps {

/// A sum of square roots of rational numbers >= 0, such as the length of a chain of edges. Such a
/// sum is rational only if every root is, so it can always be compared with a rational number.
class Roots {
 public:
  Roots() = default;
  explicit Roots(std::vector<Rational> squares) : squares_(std::move(squares)) {}

  void add(Rational square) { squares_.push_back(std::move(square)); }
  /// -1, 0, +1: the sum is less than, equal to, greater than the value. **Exact**.
  int compare(const Rational& value) const;
  /// **Rounded**, within some units in the last place.
  double rounded() const;
  /// The least double that is not less than the sum. **Exact**.
  double rounded_up() const;

 private:
  std::vector<Rational> squares_;
};

/// The least double that is not less than the square root.
double root_rounded_up(const Rational& square);

}  // namespace plumbline::diagnose_steps
