// What makes a number simple.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {

Simplicity simplicity(double number) { return {shortest_text(number).size(), std::abs(number)}; }

Simplicity simplicity(const Lines& lines) {
  Simplicity sum;
  for (const Line& line : lines) {
    for (const double number : line.numbers) {
      const Simplicity one = simplicity(number);
      sum.characters += one.characters;
      sum.size += one.size;
    }
  }
  return sum;
}

double with_digits(double number, int digits) {
  return std::strtod(fmt::format("{:.{}e}", number, digits - 1).c_str(), nullptr) + 0.0;
}

}  // namespace plumbline::minimise_steps
