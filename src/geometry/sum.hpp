#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/number.hpp"

namespace plumbline {

/// The sum of the terms, added in pairs: fractions without common denominators, added one after the
/// other, would make a number that is as long as all of them together at every step. Cost: that of
/// some multiplications of the final length.
inline Rational sum_of(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  for (std::size_t step = 1; step < terms.size(); step *= 2) {
    for (std::size_t i = 0; i + step < terms.size(); i += 2 * step) terms[i] += terms[i + step];
  }
  return terms.front();
}

}  // namespace plumbline
