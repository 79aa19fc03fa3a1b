// An operation repairs what is as small as accidents are: up to the unit in which the drawing was
// made, and up to where the sizes of what it could repair have a clear gap, below all details.

#include "repair/tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/line_graph.hpp"
#include "geometry/authored_unit.hpp"
#include "repair/gifts.hpp"
#include "repair/growths.hpp"

namespace plumbline::repair_steps {
namespace {

/// A gap between sizes is clear where they differ so many times.
constexpr double kClearRatio = 4;
/// A smaller one is told where there is no clear gap.
constexpr double kLeastRatio = 1.5;
/// Sizes are looked at up to this part of the drawing; repaired ones are a quarter of that at most.
constexpr double kSearchedPart = 50;
/// Nor are they longer than this part of an ordinary line.
constexpr double kPartOfLine = 16;
/// Accidents above the unit are of a kind: the largest is no more than so many times the smallest.
constexpr double kMostSpread = 8;
/// Narrow things are looked at up to so many units.
constexpr double kSearchedUnits = 8;
/// A unit larger than this part of the drawing is none: its numbers are round.
constexpr double kUnitPart = 2000;
/// What is as large as the unit may be larger by the drift of printed doubles.
constexpr double kJustAbove = 1 + 0x1p-30;
/// Rounding of doubles, of the largest coordinate.
constexpr double kDrift = 0x1p-46;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A value of three digits that is no less.
Rational rounded_up(double value) {
  for (int digits = 2; digits < 17; ++digits) {
    const double rounded = std::strtod(fmt::format("{:.{}e}", value, digits).c_str(), nullptr);
    if (rounded >= value) return parse_decimal(shortest_text(rounded));
    const double up = value * (1 + 0.5 * std::pow(10.0, -digits));
    const double next = std::strtod(fmt::format("{:.{}e}", up, digits).c_str(), nullptr);
    if (next >= value) return parse_decimal(shortest_text(next));
  }
  return rational_from(value);
}

std::string shown(double value) { return fmt::format("{:.3g}", value); }

/// A loose end that would run on belongs to something larger than its way.
std::vector<Size> growth_sizes(const Work& work, const Arranged& arranged, const Rational& most,
                               double least) {
  const diagnose_steps::LineGraph graph(arranged.complex);
  const auto reach_of = [&](const Tip& tip) {
    const diagnose_steps::Chain chain = graph.chain(tip.vertex, graph.edges(tip.vertex).front());
    double reach = 0;
    VertexId v = tip.vertex;
    for (const EdgeId e : chain.edges) {
      v = graph.other_end(e, v);
      const PointD &p = graph.rounded(v), &q = graph.rounded(tip.vertex);
      reach = std::max(reach, std::hypot(p.x - q.x, p.y - q.y));
    }
    return reach;
  };
  std::vector<Size> sizes;
  for (const Growth& growth : growths(work, arranged, most)) {
    const double size = nearest_sqrt(growth.squared_length);
    double reach = reach_of(growth.tip);
    if (growth.other) reach = std::min(reach, reach_of(*growth.other));
    // What is no longer than the unit is short of it by rounding, however small it is itself.
    sizes.push_back({size, size <= least * kJustAbove || reach >= kClearRatio * size});
  }
  return sizes;
}

std::vector<Size> sizes_of(const std::vector<Rational>& squares, bool is_accident = true) {
  std::vector<Size> sizes;
  for (const Rational& square : squares) sizes.push_back({nearest_sqrt(square), is_accident});
  return sizes;
}

}  // namespace

/// The sizes of one operation.
struct Choice::Ladder {
  std::string name;  ///< of the operation
  std::vector<Size> sizes;
  double searched = 0;  ///< sizes above are not listed
  double most = 0;      ///< larger ones are no accidents
};

Choice::Choice(const SegmentSet& input, std::vector<std::string>& reasons)
    : extent_(extent(input).longer_side()), unit_(input.authored_unit), reasons_(reasons) {
  AuthoredUnit unit;
  double largest = 0;
  std::vector<double> lengths;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    for (const Number& number : n) {
      unit.add(number, 1);
      largest = std::max(largest, std::abs(nearest_double(number)));
    }
    lengths.push_back(std::hypot(nearest_double(n[2]) - nearest_double(n[0]),
                                 nearest_double(n[3]) - nearest_double(n[1])));
  }
  if (unit_ == 0) unit_ = unit.unit();
  if (unit_ * kUnitPart > extent_) unit_ = 0;
  least_ = std::max(unit_, kDrift * largest);
  line_ = median(std::move(lengths));
}

Rational Choice::choose(Ladder ladder) {
  std::vector<Size>& sizes = ladder.sizes;
  std::ranges::sort(sizes, [](const Size& p, const Size& q) {
    return p.size != q.size ? p.size < q.size : p.is_accident < q.is_accident;
  });
  std::size_t sure = 0;  // no larger than the unit
  while (sure < sizes.size() && sizes[sure].size <= least_ * kJustAbove &&
         sizes[sure].is_accident) {
    ++sure;
  }
  std::size_t best = sure;  // how many are repaired
  double widest = kClearRatio;
  std::vector<double> possible;
  for (std::size_t i = sure; i < sizes.size(); ++i) {
    if (!sizes[i].is_accident || sizes[i].size > ladder.most ||
        sizes[i].size > kMostSpread * sizes[sure].size) {
      break;
    }
    const double next = i + 1 < sizes.size() ? sizes[i + 1].size : ladder.searched;
    if (next / sizes[i].size > kLeastRatio) possible.push_back(sizes[i].size);
    if (next < widest * sizes[i].size) continue;
    widest = next / sizes[i].size;
    best = i + 1;
  }
  const auto say = [&](const std::string& text) { reasons_.push_back(ladder.name + " " + text); };
  if (best == 0) {
    if (possible.empty()) {
      say(sizes.empty() ? "off: nothing to repair"
                        : fmt::format("off: nothing as small as an accident; the smallest is {}",
                                      shown(sizes.front().size)));
    } else {
      possible.resize(std::min<std::size_t>(possible.size(), 2));
      std::string values;
      for (const double value : possible) values += (values.empty() ? "" : " or ") + shown(value);
      say(fmt::format("off: no clear gap between sizes; {} would be possible", values));
    }
    return 0;
  }
  const double largest = sizes[best - 1].size;
  // Below the next size, which may be a detail as small as the unit.
  const bool is_unit_free = best == sizes.size() || sizes[best].size > least_ * kJustAbove;
  const Rational value =
      rounded_up(is_unit_free && best == sure ? std::max(largest, least_) : largest);
  const std::string next = best < sizes.size() ? "the next one is " + shown(sizes[best].size)
                                               : "none other is up to " + shown(ladder.searched);
  say(fmt::format("{}: {} of up to {}{}; {}", tolerance_text(value), best, shown(largest),
                  best == sure && unit_ > 0 ? ", no more than the last decimal" : "", next));
  return value;
}

/// What moves or removes walls goes up to the unit: what is wider may be a wall.
Choice::Ladder Choice::narrow_ladder(const char* name) const {
  return {name, {}, kSearchedUnits * least_, least_};
}

Choice::Ladder Choice::wide_ladder(const char* name) const {
  const double searched = extent_ / kSearchedPart;
  return {name, {}, searched, std::min(searched / kClearRatio, line_ / kPartOfLine)};
}

Rational Choice::weld(Work& work, const Arranged& arranged) {
  Ladder ladder = narrow_ladder("weld");
  ladder.sizes = sizes_of(weld_offsets(work, arranged, rational_from(ladder.searched)));
  return choose(std::move(ladder));
}

Rational Choice::grow(const Work& work, const Arranged& arranged) {
  Ladder ladder = wide_ladder("grow");
  ladder.sizes = growth_sizes(work, arranged, rational_from(ladder.searched), least_);
  return choose(std::move(ladder));
}

Rational Choice::trim(Work& work, const Arranged& arranged) {
  Ladder ladder = wide_ladder("trim");
  const LooseReaches reaches = loose_reaches(work, arranged, rational_from(ladder.searched));
  ladder.sizes = sizes_of(reaches.past);
  const std::vector<Size> others = sizes_of(reaches.others, false);
  ladder.sizes.insert(ladder.sizes.end(), others.begin(), others.end());
  return choose(std::move(ladder));
}

Rational Choice::sliver(const Work& work, const Arranged& arranged) {
  Ladder ladder = narrow_ladder("sliver");
  std::vector<Rational> widths;
  for (const Gift& gift : gifts(work, arranged, rational_from(ladder.searched))) {
    widths.push_back(gift.squared_size);
  }
  ladder.sizes = sizes_of(widths);
  return choose(std::move(ladder));
}

}  // namespace plumbline::repair_steps
