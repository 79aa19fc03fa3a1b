// Rings and numbers on top of a panel, in pixels.

#include "output/svg/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plumbline {
namespace {

constexpr double kLargestRing = 8, kSmallestRing = 3;
constexpr double kFontSize = 13;
constexpr double kDigitWidth = 0.62 * kFontSize;  // digits of the usual sans-serif fonts
constexpr double kLabelGap = 6, kBaseline = 2;
constexpr double kSameRing = 2;  // pixels; rings closer than this look like one
constexpr double kBucket = 5;    // pixels; space for labels is handed out in such squares
constexpr std::size_t kMaxOnLabel = 4;

/// The numbers of the findings of each ring, by its place.
using Rings = std::map<std::pair<long, long>, std::pair<PointD, std::vector<std::size_t>>>;

Rings rings_of(const std::vector<FindingPlace>& places) {
  Rings rings;
  for (const FindingPlace& finding : places) {
    auto& ring =
        rings[{std::lround(finding.place.x / kSameRing), std::lround(finding.place.y / kSameRing)}];
    if (ring.second.empty()) ring.first = finding.place;
    ring.second.push_back(finding.number);
  }
  return rings;
}

std::string label_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kMaxOnLabel); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
  }
  return numbers.size() > kMaxOnLabel ? text + ", \u2026" : text;
}

/// The radius of the rings: smaller where there are very many of them.
double ring_radius(std::size_t rings) {
  const double crowd = static_cast<double>(rings) / static_cast<double>(kAllNumbered);
  return std::clamp(kLargestRing / std::sqrt(std::max(crowd, 1.0)), kSmallestRing, kLargestRing);
}

/// Hands out the space of a panel.
class Space {
 public:
  explicit Space(const svg::Box& panel) : panel_(panel) {}

  /// Takes the box, whatever is there.
  void reserve(const svg::Box& box) {
    const auto squares = squares_of(box);
    taken_.insert(squares.begin(), squares.end());
  }

  /// Takes the box unless it leaves the panel or a part of it is taken.
  bool take(const svg::Box& box) {
    if (box.low.x < panel_.low.x || box.high.x > panel_.high.x || box.low.y < panel_.low.y ||
        box.high.y > panel_.high.y) {
      return false;
    }
    const auto squares = squares_of(box);
    const auto is_taken = [&](const auto& square) { return taken_.contains(square); };
    if (std::any_of(squares.begin(), squares.end(), is_taken)) return false;
    taken_.insert(squares.begin(), squares.end());
    return true;
  }

 private:
  static std::vector<std::pair<long, long>> squares_of(const svg::Box& box) {
    std::vector<std::pair<long, long>> squares;
    for (long x = std::lround(box.low.x / kBucket); x <= std::lround(box.high.x / kBucket); ++x) {
      for (long y = std::lround(box.low.y / kBucket); y <= std::lround(box.high.y / kBucket); ++y) {
        squares.emplace_back(x, y);
      }
    }
    return squares;
  }

  svg::Box panel_;
  std::set<std::pair<long, long>> taken_;
};

/// Places of a label beside a ring, the preferred one first.
std::vector<svg::Box> label_boxes(const PointD& ring, double radius, double width) {
  const double away = radius + kLabelGap, half = kFontSize / 2;
  const auto box = [&](double x, double y) {
    return svg::Box{{ring.x + x, ring.y + y}, {ring.x + x + width, ring.y + y + kFontSize}};
  };
  return {box(away, -half),
          box(-away - width, -half),
          box(-width / 2, -away - kFontSize),
          box(-width / 2, away),
          box(away, -away - kFontSize),
          box(away, away),
          box(-away - width, -away - kFontSize),
          box(-away - width, away)};
}

void append_label(std::string& svg, const svg::Box& box, const std::string& text) {
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", box.low.x,
                     box.high.y - kBaseline, text);
}

}  // namespace

std::string labelled_rings(const std::vector<FindingPlace>& places, const svg::Box& panel) {
  const Rings rings = rings_of(places);
  const double radius = ring_radius(rings.size());
  std::string svg = fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\">\n",
                                svg::kMark, radius / 5);
  for (const auto& [key, ring] : rings) {
    svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>\n", ring.first.x,
                       ring.first.y, radius);
  }
  svg += fmt::format(
      "</g>\n<g fill=\"{}\" font-size=\"{}\" font-weight=\"bold\" stroke=\"#ffffff\" "
      "stroke-width=\"3\" paint-order=\"stroke\">\n",
      svg::kMark, kFontSize);
  Space space(panel);
  for (const auto& [key, ring] : rings) {
    space.reserve({{ring.first.x - radius, ring.first.y - radius},
                   {ring.first.x + radius, ring.first.y + radius}});
  }
  for (const auto& [key, ring] : rings) {
    const std::string text = label_text(ring.second);
    const std::vector<svg::Box> boxes =
        label_boxes(ring.first, radius, static_cast<double>(text.size()) * kDigitWidth);
    const auto box = std::find_if(boxes.begin(), boxes.end(),
                                  [&](const svg::Box& candidate) { return space.take(candidate); });
    if (box != boxes.end()) {
      append_label(svg, *box, text);
    } else if (places.size() <= kAllNumbered) {
      append_label(svg, boxes.front(), text);
    }
  }
  return svg + "</g>\n";
}

}  // namespace plumbline
