// Numbers that DXF has for colours and units.

#include "output/features/dxf_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumbline::features {
namespace {

using Colour = std::array<int, 3>;

constexpr std::array<Colour, 9> kFirst{{{255, 0, 0},
                                        {255, 255, 0},
                                        {0, 255, 0},
                                        {0, 255, 255},
                                        {0, 0, 255},
                                        {255, 0, 255},
                                        {255, 255, 255},
                                        {128, 128, 128},
                                        {192, 192, 192}}};
constexpr int kFirstHue = 10, kFirstGrey = 250, kLast = 255;
constexpr std::array<int, 6> kGreys{51, 80, 105, 130, 190, 255};

/// Of 24 hues, each of five values, full (even) and half saturated.
Colour hue_colour(int index) {
  constexpr std::array<int, 5> kValues{255, 165, 127, 76, 38};
  constexpr int kHues = 24;
  const int hue = index / 10 - 1;
  const int value = kValues.at(static_cast<std::size_t>(index % 10 / 2));
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const int way = std::abs(hue - static_cast<int>(8 * i));
    const int quarters = std::clamp(8 - std::min(way, kHues - way), 0, 4);
    colour.at(i) = index % 2 == 0 ? value * quarters / 4 : value * (4 + quarters) / 8;
  }
  return colour;
}

Colour colour_of(int index) {
  if (index < kFirstHue) return kFirst.at(static_cast<std::size_t>(index - 1));
  if (index < kFirstGrey) return hue_colour(index);
  const int grey = kGreys.at(static_cast<std::size_t>(index - kFirstGrey));
  return {grey, grey, grey};
}

}  // namespace

int colour_index(const std::optional<std::uint32_t>& rgb) {
  if (!rgb || *rgb == 0) return kWhiteOrBlack;
  const auto part = [&rgb](unsigned shift) { return static_cast<int>((*rgb >> shift) & 0xffU); };
  const Colour wanted{part(16), part(8), part(0)};
  std::pair<int, int> best{3 * 256 * 256, 0};  // squared distance, index
  for (int index = 1; index <= kLast; ++index) {
    const Colour colour = colour_of(index);
    int distance = 0;
    for (std::size_t i = 0; i < colour.size(); ++i) {
      distance += (colour.at(i) - wanted.at(i)) * (colour.at(i) - wanted.at(i));
    }
    best = std::min(best, {distance, index});
  }
  return best.second;
}

int unit_number(const Rational& metres) {
  static const std::array<std::pair<Rational, int>, 9> kUnits{{{Rational(127, 5000), 1},  // inch
                                                               {Rational(381, 1250), 2},
                                                               {Rational(201168, 125), 3},
                                                               {Rational(1, 1000), 4},
                                                               {Rational(1, 100), 5},
                                                               {Rational(1), 6},
                                                               {Rational(1000), 7},
                                                               {Rational(1143, 1250), 10},
                                                               {Rational(1, 10), 14}}};
  const auto found = std::ranges::find(kUnits, metres, &std::pair<Rational, int>::first);
  return found == kUnits.end() ? 0 : found->second;
}

}  // namespace plumbline::features
