#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plumbline/error.hpp"
#include "plumbline/geometry/extent.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// Two digits: 4000 of 3987.
double two_digits(double value) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 1));
  return std::round(value / unit) * unit;
}

/// "4,000"; a power of ten where that is easier to read.
std::string count_text(double value) {
  constexpr double kMostDigits = 1e9;
  if (value >= kMostDigits) return fmt::format("{:.0e}", value);
  std::string digits = fmt::format("{:.0f}", value);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

}  // namespace

std::string stray_text(const SegmentSet& input) {
  const Extent found = extent(input);
  if (found.stray.empty()) return {};
  std::vector<SourceId> elements;
  for (const std::size_t s : found.stray) elements.push_back(input.segment_source[s]);
  const Source first = input.sources[elements.front()];
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  const bool is_one = elements.size() == 1;
  return fmt::format("{} element{} {} {} drawing sizes away{}: {}{}", elements.size(),
                     is_one ? "" : "s", is_one ? "lies" : "lie",
                     count_text(two_digits(found.sizes_away)), is_one ? "" : " or more",
                     first.layer.empty() ? "" : "layer " + line_text(first.layer) + ", ",
                     line_text(to_text(first, input.files)));
}

}  // namespace plumbline
