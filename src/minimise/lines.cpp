// The segments on trial, and the order that is their own.

#include <algorithm>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {

Lines lines_of(const SegmentSet& input) {
  Lines result;
  result.reserve(input.segments.size());
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    Line line{{}, input.rounding.empty() ? 0 : input.rounding[s], s};
    const auto numbers = input.segments.numbers(s);
    std::ranges::transform(numbers, line.numbers.begin(),
                           [](const Number& number) { return nearest_double(number); });
    const auto& [ax, ay, bx, by] = line.numbers;
    if (ax != bx || ay != by) result.push_back(line);
  }
  return result;
}

SegmentSet drawing_of(const Lines& lines, const SegmentSet& input) {
  SegmentSet result;
  result.files = input.files;
  result.crs = input.crs;
  result.unit = input.unit;
  result.y_up = input.y_up;
  result.segments.reserve(lines.size());
  const bool is_printed =
      std::ranges::any_of(lines, [](const Line& line) { return line.rounding > 0; });
  for (const Line& line : lines) {
    const bool is_sourced = line.origin < input.segment_source.size() &&
                            input.segment_source[line.origin] < input.sources.size();
    const SourceId source =
        result.add_source(is_sourced ? input.sources[input.segment_source[line.origin]] : Source{});
    const auto& [ax, ay, bx, by] = line.numbers;
    const std::size_t before = result.segments.size();
    result.add(PointD{ax, ay}, PointD{bx, by}, source);
    if (is_printed && result.segments.size() > before) result.rounding.push_back(line.rounding);
  }
  return result;
}

Lines in_own_order(const Lines& lines, Trials& trials) {
  Lines result = lines;
  for (Line& line : result) {
    auto& [ax, ay, bx, by] = line.numbers;
    if (std::pair(bx, by) < std::pair(ax, ay)) {
      std::swap(ax, bx);
      std::swap(ay, by);
    }
  }
  std::ranges::stable_sort(result, {}, &Line::numbers);
  return result == lines || !trials.show(result) ? lines : result;
}

}  // namespace plumbline::minimise_steps
