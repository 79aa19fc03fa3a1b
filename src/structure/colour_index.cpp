#include "structure/colour_index.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline {
namespace {

constexpr std::array<std::uint32_t, 10> kFirstColours{
    0, 0xff0000, 0xffff00, 0x00ff00, 0x00ffff, 0x0000ff, 0xff00ff, 0xffffff, 0x808080, 0xc0c0c0};
constexpr std::array<std::uint32_t, 6> kGreys{0x333333, 0x505050, 0x696969,
                                              0x828282, 0xbebebe, 0xffffff};
constexpr std::int64_t kFirstHue = 10, kFirstGrey = 250, kWhiteOrBlack = 7;

/// How strong a component is whose hue is the farther away the more quarters of a sixth of the
/// circle lie between, in quarters.
std::int64_t quarters(std::int64_t distance) {
  return std::clamp<std::int64_t>(8 - distance, 0, 4);
}

}  // namespace

std::optional<std::uint32_t> rgb_of_colour(std::int64_t number) {
  if (number < 1 || number > 255 || number == kWhiteOrBlack) return {};
  if (number < kFirstHue) return kFirstColours.at(static_cast<std::size_t>(number));
  if (number >= kFirstGrey) return kGreys.at(static_cast<std::size_t>(number - kFirstGrey));
  // 24 hues, each of five values, full and half saturated.
  constexpr std::array<std::int64_t, 5> kValues{255, 165, 127, 76, 38};
  constexpr std::int64_t kHues = 24;
  const std::int64_t hue = (number - kFirstHue) / 10;
  const std::int64_t value = kValues.at(static_cast<std::size_t>(number % 10 / 2));
  std::uint32_t rgb = 0;
  for (const std::int64_t own : {0, 8, 16}) {
    const std::int64_t way = std::abs(hue - own);
    std::int64_t part = quarters(std::min(way, kHues - way));
    if (number % 2 != 0) part = 4 + part;
    rgb = rgb << 8U | static_cast<std::uint32_t>(value * part / (number % 2 != 0 ? 8 : 4));
  }
  return rgb;
}

std::int64_t colour_number(const std::optional<std::uint32_t>& rgb) {
  if (!rgb || *rgb == 0) return kWhiteOrBlack;
  constexpr std::int64_t kLast = 255;
  std::pair<std::int64_t, std::int64_t> best{0x40000, 0};  // squared distance, number
  for (std::int64_t number = 1; number <= kLast; ++number) {
    const std::uint32_t colour = rgb_of_colour(number).value_or(0xffffff);
    std::int64_t distance = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
      const std::int64_t off = static_cast<std::int64_t>((colour >> shift) & 0xffU) -
                               static_cast<std::int64_t>((*rgb >> shift) & 0xffU);
      distance += off * off;
    }
    best = std::min(best, {distance, number});
  }
  return best.second;
}

}  // namespace plumbline
