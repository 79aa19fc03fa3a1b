#include "arrange/bucket/lines.hpp"

#include <utility>

namespace plumbline::bucket {

std::uint32_t hilbert(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t side = 1U << 15U; side > 0; side >>= 1U) {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0, upper = (y & side) != 0 ? 1 : 0;
    position = (position << 2U) | ((3 * right) ^ upper);
    if (upper != 0) continue;
    if (right != 0) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return position;
}

namespace {

/// A range around nearly all of the sorted values; all of [low, high] if that is not much wider.
std::pair<double, double> core(double low, double high, const std::vector<double>& values) {
  constexpr std::size_t kEnough = 64, kTail = 100;
  if (values.size() < kEnough) return {low, high};
  const double from = values[values.size() / kTail];
  const double to = values[values.size() - 1 - values.size() / kTail];
  const double wider = (to - from) / 4;
  if (!(to - from > 0) || !(to - from + 2 * wider < (high - low) / 2)) return {low, high};
  return {std::max(low, from - wider), std::min(high, to + wider)};
}

}  // namespace

Box core_of(const Box& whole, const Sample& sample) {
  const auto [x0, x1] = core(whole.x0, whole.x1, sample.x);
  const auto [y0, y1] = core(whole.y0, whole.y1, sample.y);
  return {x0, y0, x1, y1};
}

}  // namespace plumbline::bucket
