// One map for all numbers: to the origin, to another scale, to fewer digits.

#include <algorithm>
#include <cmath>
#include <functional>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {
namespace {

constexpr int kMostDecimals = 15;

/// `change` of each number and whether it is a y.
template <class Change>
Lines changed(Lines lines, Change change) {
  for (Line& line : lines) {
    for (std::size_t k = 0; k < line.numbers.size(); ++k) {
      const double number = change(line.numbers[k], k % 2 == 1) + 0.0;  // -0 is 0
      if (number != line.numbers[k]) line.rounding = 0;
      line.numbers[k] = number;
    }
  }
  return lines;
}

Lines moved(const Lines& lines, const PointD& by) {
  return changed(lines, [&](double number, bool is_y) { return number - (is_y ? by.y : by.x); });
}

PointD low_corner(const Lines& lines) {
  PointD low{lines[0].numbers[0], lines[0].numbers[1]};
  for (const Line& line : lines) {
    const auto& [ax, ay, bx, by] = line.numbers;
    low = {std::min({low.x, ax, bx}), std::min({low.y, ay, by})};
  }
  return low;
}

double with_decimals(double number, int decimals) {
  const double unit = std::pow(10.0, decimals);
  const double scaled = std::round(number * unit);
  return std::isfinite(scaled) ? scaled / unit : number;
}

Lines scaled(const Lines& lines, double factor) {
  return changed(lines, [&](double number, bool) { return number * factor; });
}

/// Drawings to try, those with the simplest numbers first.
std::vector<Lines> candidates(const Lines& lines) {
  const PointD low = low_corner(lines);
  const PointD first{lines[0].numbers[0], lines[0].numbers[1]};
  std::vector<Lines> places{lines,
                            moved(lines, low),
                            moved(lines, first),
                            moved(lines, {std::floor(low.x), std::floor(low.y)}),
                            moved(lines, {low.x, 0}),
                            moved(lines, {0, low.y})};
  std::vector<Lines> result(places.begin() + 1, places.end());
  for (const Lines& place : places) {
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
      result.push_back(
          changed(place, [&](double number, bool) { return with_decimals(number, decimals); }));
    }
  }
  for (const double base : {2.0, 10.0}) {
    for (int power = 1; power <= 9; ++power) {
      result.push_back(scaled(lines, std::pow(base, power)));
      result.push_back(scaled(lines, 1 / std::pow(base, power)));
    }
  }
  const Simplicity now = simplicity(lines);
  std::erase_if(result, [&](const Lines& other) { return !(simplicity(other) < now); });
  std::ranges::stable_sort(result, {}, [](const Lines& other) { return simplicity(other); });
  return result;
}

}  // namespace

Lines simpler_together(Lines lines, Trials& trials) {
  for (bool again = !lines.empty(); again && !trials.have_ended();) {
    again = false;
    for (Lines& other : candidates(lines)) {
      if (!trials.show(other)) continue;
      lines = std::move(other);
      again = true;
      break;
    }
  }
  return lines;
}

}  // namespace plumbline::minimise_steps
