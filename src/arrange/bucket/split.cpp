#include "arrange/bucket/split.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::bucket {
namespace {

/// A split must leave fewer than this times the lines in its two parts together. A little more than
/// where half the lines go along the split and half across it.
constexpr double kProgress = 1.55;
/// Where more than this share of the pairs cross, tests of pairs are not wasted, but smaller
/// buckets are done in parallel; then a split may leave nearly all lines on both sides.
constexpr double kDense = 0.2, kProgressIfDense = 1.9;
/// Where a split along x or y leaves more than kGood times the lines in its parts, and more than
/// kAligned of them agree in direction, they may be split across that.
constexpr double kGood = 1.1, kAligned = 0.9;

/// What a few pairs of lines say about all of them, as far as doubles can tell.
struct PairSample {
  bool pencil = false;  ///< nearly all lines go through one point
  double crossing = 0;  ///< the share of pairs that cross inside the box
};

bool is_pencil(const PointD& p, double slack, const std::vector<LineId>& members,
               std::span<const Approx> lines, const Margin& margin) {
  constexpr std::size_t kProbes = 64;
  constexpr double kNearly = 0.9;
  std::size_t through = 0;
  for (std::size_t k = 0; k < kProbes; ++k) {
    const Approx& l = lines[members[k * members.size() / kProbes]];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double off = dx * (p.y - l.ay) - dy * (p.x - l.ax);
    if (std::abs(off) <= slack * margin(l) * (std::abs(dx) + std::abs(dy))) ++through;
  }
  return static_cast<double>(through) >= kNearly * kProbes;
}

PairSample look_at_pairs(const Box& box, const std::vector<LineId>& members,
                         std::span<const Approx> lines, const Margin& margin) {
  constexpr std::size_t kPairs = 32;
  constexpr double kSlack = 16;
  PairSample result;
  PointD best{};
  double best_sine = 0;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Approx& l = lines[members[k * members.size() / (2 * kPairs)]];
    const Approx& m = lines[members[(k * 7 % kPairs + kPairs) * members.size() / (2 * kPairs)]];
    const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = m.bx - m.ax, ey = m.by - m.ay;
    const double turn = dx * ey - dy * ex;
    const double sine = std::abs(turn) / std::sqrt((dx * dx + dy * dy) * (ex * ex + ey * ey));
    if (!(sine > 0)) continue;
    const double t = ((m.ax - l.ax) * ey - (m.ay - l.ay) * ex) / turn;
    const double u = ((m.ax - l.ax) * dy - (m.ay - l.ay) * dx) / turn;
    const PointD p{l.ax + t * dx, l.ay + t * dy};
    if (t >= 0 && t <= 1 && u >= 0 && u <= 1 && box.x0 <= p.x && p.x <= box.x1 && box.y0 <= p.y &&
        p.y <= box.y1) {
      result.crossing += 1.0 / kPairs;
    }
    if (sine > best_sine) {
      best_sine = sine;
      best = p;
    }
  }
  result.pencil = best_sine > 0 && is_pencil(best, kSlack / best_sine, members, lines, margin);
  return result;
}

/// Splits at the centroid of the parts of the lines inside the box.
Split split_along(const PointD& normal, const Box& box, const std::vector<LineId>& members,
                  std::span<const Approx> lines, const Margin& margin) {
  struct Range {
    double low, high;
  };
  std::vector<Range> ranges;
  ranges.reserve(members.size());
  Split result;
  result.normal = normal;
  for (const LineId s : members) {
    // A point within the margin of the line, and the rounding of its projection.
    const double slack = 2 * margin(lines[s]);
    const auto [p, q] = clipped(lines[s], box, slack);
    const auto [low, high] =
        std::minmax({normal.x * p.x + normal.y * p.y, normal.x * q.x + normal.y * q.y});
    ranges.push_back({low - slack, high + slack});
    result.at += (low + high) / 2;
  }
  result.at /= static_cast<double>(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (ranges[i].low <= result.at) result.low.push_back(members[i]);
    if (ranges[i].high >= result.at) result.high.push_back(members[i]);
  }
  return result;
}

/// The normal of the split that puts the fewest lines on both sides, judged by some of them.
PointD best_normal(const Box& box, const std::vector<LineId>& members,
                   std::span<const Approx> lines, const Margin& margin) {
  constexpr std::size_t kSome = 64;
  std::vector<LineId> some;
  const std::size_t count = std::min(members.size(), kSome);
  for (std::size_t k = 0; k < count; ++k) some.push_back(members[k * members.size() / count]);
  const auto size = [&](const PointD& normal) {
    return split_along(normal, box, some, lines, margin).size();
  };
  const PointD x{1, 0}, y{0, 1};
  const std::size_t along_x = size(x), along_y = size(y), least = std::min(along_x, along_y);
  if (static_cast<double>(least) > kGood * static_cast<double>(count)) {
    const MeanNormal common = mean_normal(some, lines);
    if (common.agreement > kAligned && size(common.normal) < least) return common.normal;
  }
  return along_y < along_x ? y : x;
}

}  // namespace

MeanNormal mean_normal(std::span<const LineId> members, std::span<const Approx> lines) {
  double c = 0, s = 0;  // of the doubled angle, so that opposite directions agree
  for (const LineId line : members) {
    const Approx& l = lines[line];
    const double dx = l.bx - l.ax, dy = l.by - l.ay, length2 = dx * dx + dy * dy;
    if (!(length2 > 0)) continue;
    c += (dx * dx - dy * dy) / length2;
    s += 2 * dx * dy / length2;
  }
  const double angle = std::atan2(s, c) / 2;
  return {{-std::sin(angle), std::cos(angle)},
          std::sqrt(c * c + s * s) / static_cast<double>(members.size())};
}

std::pair<PointD, PointD> clipped(const Approx& l, const Box& box, double slack) {
  double t0 = 0, t1 = 1;
  const auto clip = [&](double from, double d, double low, double high) {
    if (d == 0) return;
    double u = (low - slack - from) / d, v = (high + slack - from) / d;
    if (v < u) std::swap(u, v);
    t0 = std::max(t0, u);
    t1 = std::min(t1, v);
  };
  const double dx = l.bx - l.ax, dy = l.by - l.ay;
  clip(l.ax, dx, box.x0, box.x1);
  clip(l.ay, dy, box.y0, box.y1);
  if (!(t0 <= t1)) return {{l.ax, l.ay}, {l.bx, l.by}};
  return {{l.ax + t0 * dx, l.ay + t0 * dy}, {l.ax + t1 * dx, l.ay + t1 * dy}};
}

Split split(const Box& box, const std::vector<LineId>& members, std::span<const Approx> lines,
            const Margin& margin) {
  if (members.size() <= kFullBucket) return {};
  const PairSample pairs = look_at_pairs(box, members, lines, margin);
  if (pairs.pencil) return {};
  const PointD normal = best_normal(box, members, lines, margin);
  Split best = split_along(normal, box, members, lines, margin);
  best.low_box = best.high_box = box;
  if (normal.y == 0) best.low_box.x1 = best.high_box.x0 = best.at;
  if (normal.x == 0) best.low_box.y1 = best.high_box.y0 = best.at;
  const double count = static_cast<double>(members.size());
  best.useful = static_cast<double>(best.size()) <
                (pairs.crossing > kDense ? kProgressIfDense : kProgress) * count;
  return best;
}

}  // namespace plumbline::bucket
