// Numbers that DXF has for units.

#include "output/features/dxf_units.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline::features {

int unit_number(const Rational& metres) {
  static const std::array<std::pair<Rational, int>, 9> units{{{Rational(127, 5000), 1},  // inch
                                                              {Rational(381, 1250), 2},
                                                              {Rational(201168, 125), 3},
                                                              {Rational(1, 1000), 4},
                                                              {Rational(1, 100), 5},
                                                              {Rational(1), 6},
                                                              {Rational(1000), 7},
                                                              {Rational(1143, 1250), 10},
                                                              {Rational(1, 10), 14}}};
  const auto found = std::ranges::find(units, metres, &std::pair<Rational, int>::first);
  return found == units.end() ? 0 : found->second;
}

}  // namespace plumbline::features
