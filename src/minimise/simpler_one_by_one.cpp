// One number after the other: wherever it stands on its axis, then at one vertex, then at one end
// of one segment.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {
namespace {

constexpr int kMostDigits = 16;

/// A coordinate: which number of which line.
struct Place {
  std::size_t line = 0, number = 0;

  bool is_y() const { return number % 2 == 1; }
  friend auto operator<=>(const Place&, const Place&) = default;
};
using Places = std::vector<Place>;

PointD end_at(const Lines& lines, const Place& place) {
  const auto& numbers = lines[place.line].numbers;
  const std::size_t first = place.number / 2 * 2;
  return {numbers[first], numbers[first + 1]};
}

/// Which coordinates change together with one.
enum class Together { OnAxis, AtVertex, Alone };

Places together(const Lines& lines, const Place& place, Together which) {
  if (which == Together::Alone) return {place};
  const double number = lines[place.line].numbers[place.number];
  Places result;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t k = place.number % 2; k < 4; k += 2) {
      if (lines[l].numbers[k] != number) continue;
      const bool is_at_vertex = end_at(lines, {l, k}) == end_at(lines, place);
      if (which == Together::OnAxis || is_at_vertex) result.push_back({l, k});
    }
  }
  return result;
}

/// Simpler numbers, the simplest first: small integers, those of the axis, fewer digits.
std::vector<double> simpler_numbers(const Lines& lines, const Place& place) {
  const double number = lines[place.line].numbers[place.number];
  const Simplicity now = simplicity(number);
  std::set<double> values;
  for (const int small : {0, 1, 2, 3, 4, 5, 10}) values.insert(std::copysign(small, number) + 0.0);
  for (const Line& line : lines) {
    values.insert({line.numbers[place.number % 2], line.numbers[place.number % 2 + 2]});
  }
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    const double fewer = with_digits(number, digits);
    values.insert(fewer);
  }
  values.insert({std::floor(number) + 0.0, std::ceil(number) + 0.0});
  std::vector<double> result;
  for (const double value : values) {
    if (std::isfinite(value) && simplicity(value) < now) result.push_back(value);
  }
  std::ranges::stable_sort(result, {}, [](double value) { return simplicity(value); });
  return result;
}

bool replace(Lines& lines, const Places& places, double number, Trials& trials) {
  Lines other = lines;
  for (const Place& place : places) {
    other[place.line].numbers[place.number] = number;
    other[place.line].rounding = 0;
  }
  if (!trials.show(other)) return false;
  lines = std::move(other);
  return true;
}

/// Every coordinate once; whether any was replaced.
bool replace_each(Lines& lines, Together which, Trials& trials) {
  bool is_changed = false;
  std::set<Place> done;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (done.contains({l, k})) continue;
      const Places places = together(lines, {l, k}, which);
      done.insert(places.begin(), places.end());
      for (const double number : simpler_numbers(lines, {l, k})) {
        if (trials.have_ended()) return is_changed;
        if (!replace(lines, places, number, trials)) continue;
        is_changed = true;
        break;
      }
    }
  }
  return is_changed;
}

}  // namespace

Lines simpler_one_by_one(Lines lines, Trials& trials) {
  for (bool again = true; again && !trials.have_ended();) {
    again = false;
    for (const Together which : {Together::OnAxis, Together::AtVertex, Together::Alone}) {
      again = replace_each(lines, which, trials) || again;
    }
  }
  return lines;
}

}  // namespace plumbline::minimise_steps
