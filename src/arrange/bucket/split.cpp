#include "arrange/bucket/split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace plumbline::bucket {
namespace {

/// A split must leave fewer than this times the lines in its two parts together. A little more than
/// where half the lines go along the split and half across it.
constexpr double kProgress = 1.55;
/// Where more than this share of the pairs cross, tests of pairs are not wasted, but smaller
/// buckets are done in parallel; then a split may leave nearly all lines on both sides.
constexpr double kDense = 0.2, kProgressIfDense = 1.9;
/// Where a split along x or y leaves more than kGood times the lines in its parts, they may be
/// split along another line.
constexpr double kGood = 1.1;

/// What a few pairs of lines say about all of them, as far as doubles can tell.
struct PairSample {
  bool pencil = false;  ///< nearly all lines go through one point
  double crossing = 0;  ///< the share of pairs that cross inside the box
};

bool is_pencil(const PointD& p, double slack, const std::vector<Piece>& members,
               std::span<const Approx> lines, const Margin& margin) {
  constexpr std::size_t kProbes = 64;
  constexpr double kNearly = 0.9;
  std::size_t through = 0;
  for (std::size_t k = 0; k < kProbes; ++k) {
    const Approx& l = lines[members[k * members.size() / kProbes].line];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double off = dx * (p.y - l.ay) - dy * (p.x - l.ax);
    if (std::abs(off) <= slack * margin(l) * (std::abs(dx) + std::abs(dy))) ++through;
  }
  return static_cast<double>(through) >= kNearly * kProbes;
}

PairSample look_at_pairs(const std::vector<Piece>& members, std::span<const Approx> lines,
                         const Margin& margin) {
  constexpr std::size_t kPairs = 32;
  constexpr double kSlack = 16;
  PairSample result;
  PointD best{};
  double best_sine = 0;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Piece& p = members[k * members.size() / (2 * kPairs)];
    const Piece& q = members[(k * 7 % kPairs + kPairs) * members.size() / (2 * kPairs)];
    const Approx &l = lines[p.line], &m = lines[q.line];
    const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = m.bx - m.ax, ey = m.by - m.ay;
    const double turn = dx * ey - dy * ex;
    const double sine = std::abs(turn) / std::sqrt((dx * dx + dy * dy) * (ex * ex + ey * ey));
    if (!(sine > 0)) continue;
    const double t = ((m.ax - l.ax) * ey - (m.ay - l.ay) * ex) / turn;
    const double u = ((m.ax - l.ax) * dy - (m.ay - l.ay) * dx) / turn;
    if (t >= p.from && t <= p.to && u >= q.from && u <= q.to) result.crossing += 1.0 / kPairs;
    if (sine > best_sine) {
      best_sine = sine;
      best = {l.ax + t * dx, l.ay + t * dy};
    }
  }
  result.pencil = best_sine > 0 && is_pencil(best, kSlack / best_sine, members, lines, margin);
  return result;
}

/// How far a piece is along a normal.
struct Range {
  double from, to;  ///< at its ends
  double slack;     ///< a point within the margin of the line, and the rounding of its projection
  double low() const { return std::min(from, to) - slack; }
  double high() const { return std::max(from, to) + slack; }
};

Range range_of(const Piece& piece, const PointD& normal, std::span<const Approx> lines,
               const Margin& margin) {
  const auto [p, q] = ends_of(piece, lines);
  return {normal.x * p.x + normal.y * p.y, normal.x * q.x + normal.y * q.y,
          2 * margin(lines[piece.line])};
}

/// The part of a piece where its distance along the normal is at most `at`, or, if `above`, at
/// least; some more of it is left on, so that rounding takes nothing off.
Piece trimmed(Piece piece, const Range& range, double at, bool above) {
  const double bound = above ? at - 2 * range.slack : at + 2 * range.slack;
  const auto is_off = [&](double v) { return above ? v < bound : v > bound; };
  if (!is_off(range.from) && !is_off(range.to)) return piece;
  const double t =
      piece.from + (piece.to - piece.from) * (bound - range.from) / (range.to - range.from);
  const double within = std::clamp(t, piece.from, piece.to);
  (is_off(range.from) ? piece.from : piece.to) = within;
  return piece;
}

/// The number of pieces in both parts of a split at the centroid, and where that is.
struct Size {
  std::size_t pieces = 0;
  double at = 0;
};

Size size_of_split(const PointD& normal, const std::vector<Piece>& members,
                   std::span<const Approx> lines, const Margin& margin) {
  Size size;
  for (const Piece& piece : members) {
    const Range range = range_of(piece, normal, lines, margin);
    size.at += (range.from + range.to) / 2;
  }
  size.at /= static_cast<double>(members.size());
  for (const Piece& piece : members) {
    const Range range = range_of(piece, normal, lines, margin);
    size.pieces += (range.low() <= size.at ? 1U : 0U) + (range.high() >= size.at ? 1U : 0U);
  }
  return size;
}

Split split_along(const PointD& normal, const std::vector<Piece>& members,
                  std::span<const Approx> lines, const Margin& margin) {
  Split result;
  result.normal = normal;
  result.at = size_of_split(normal, members, lines, margin).at;
  for (const Piece& piece : members) {
    const Range range = range_of(piece, normal, lines, margin);
    if (range.low() <= result.at) result.low.push_back(trimmed(piece, range, result.at, false));
    if (range.high() >= result.at) result.high.push_back(trimmed(piece, range, result.at, true));
  }
  return result;
}

/// The normal of a line along which the ends inside the box lie: where bundles of lines meet at
/// corners, it parts the bundles.
PointD normal_of_ends(const std::vector<Piece>& members, std::span<const Approx> lines) {
  std::vector<PointD> ends;
  for (const Piece& piece : members) {
    const Approx& l = lines[piece.line];
    if (piece.from == 0) ends.push_back({l.ax, l.ay});
    if (piece.to == 1) ends.push_back({l.bx, l.by});
  }
  PointD mean{0, 0};
  const double count = static_cast<double>(ends.size());
  for (const PointD& p : ends) mean = {mean.x + p.x / count, mean.y + p.y / count};
  double xx = 0, xy = 0, yy = 0;
  for (const PointD& p : ends) {
    xx += (p.x - mean.x) * (p.x - mean.x);
    xy += (p.x - mean.x) * (p.y - mean.y);
    yy += (p.y - mean.y) * (p.y - mean.y);
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  return {-std::sin(angle), std::cos(angle)};
}

/// The normals of the first member and of the one whose direction differs most from its.
std::array<PointD, 2> extreme_normals(const std::vector<Piece>& members,
                                      std::span<const Approx> lines) {
  const auto normal = [&](const Piece& piece) {
    const LineId s = piece.line;
    const double dx = lines[s].bx - lines[s].ax, dy = lines[s].by - lines[s].ay;
    const double length = std::hypot(dx, dy);
    if (!(length > 0) || dx == 0) return PointD{1, 0};  // the sign that a split along x has
    return PointD{-dy / length, dx / length};
  };
  const PointD first = normal(members.front());
  PointD other = first;
  double most = 0;
  for (const Piece& piece : members) {
    const PointD n = normal(piece);
    const double turn = std::abs(first.x * n.y - first.y * n.x);
    if (turn > most) {
      most = turn;
      other = n;
    }
  }
  return {first, other};
}

/// The normal of the split that puts the fewest lines on both sides, judged by some of them.
PointD best_normal(const std::vector<Piece>& members, std::span<const Approx> lines,
                   const Margin& margin) {
  constexpr std::size_t kSome = 64;
  std::vector<Piece> some;
  const std::size_t count = std::min(members.size(), kSome);
  for (std::size_t k = 0; k < count; ++k) some.push_back(members[k * members.size() / count]);
  PointD best{1, 0};
  std::size_t least = SIZE_MAX;
  const auto consider = [&](const PointD& normal) {
    const std::size_t size = size_of_split(normal, some, lines, margin).pieces;
    if (size >= least) return;
    least = size;
    best = normal;
  };
  consider({1, 0});
  consider({0, 1});
  if (static_cast<double>(least) > kGood * static_cast<double>(count)) {
    std::vector<LineId> ids;
    for (const Piece& piece : some) ids.push_back(piece.line);
    consider(mean_normal(ids, lines));
    for (const PointD& normal : extreme_normals(some, lines)) consider(normal);
    consider(normal_of_ends(some, lines));
  }
  return best;
}

}  // namespace

PointD mean_normal(std::span<const LineId> members, std::span<const Approx> lines) {
  double c = 0, s = 0;  // of the doubled angle, so that opposite directions agree
  for (const LineId line : members) {
    const Approx& l = lines[line];
    const double dx = l.bx - l.ax, dy = l.by - l.ay, length2 = dx * dx + dy * dy;
    if (!(length2 > 0)) continue;
    c += (dx * dx - dy * dy) / length2;
    s += 2 * dx * dy / length2;
  }
  const double angle = std::atan2(s, c) / 2;
  return {-std::sin(angle), std::cos(angle)};
}

Piece clipped(LineId line, std::span<const Approx> lines, const Box& box, double slack) {
  const Approx& l = lines[line];
  double t0 = 0, t1 = 1;
  const auto clip = [&](double from, double d, double low, double high) {
    if (d == 0) return;
    double u = (low - slack - from) / d, v = (high + slack - from) / d;
    if (v < u) std::swap(u, v);
    t0 = std::max(t0, u);
    t1 = std::min(t1, v);
  };
  clip(l.ax, l.bx - l.ax, box.x0, box.x1);
  clip(l.ay, l.by - l.ay, box.y0, box.y1);
  if (!(t0 <= t1)) return {line, 0, 1};
  return {line, t0, t1};
}

std::pair<PointD, PointD> ends_of(const Piece& piece, std::span<const Approx> lines) {
  const Approx& l = lines[piece.line];
  const double dx = l.bx - l.ax, dy = l.by - l.ay;
  const auto at = [&](double t) {
    if (t == 1) return PointD{l.bx, l.by};
    return PointD{l.ax + t * dx, l.ay + t * dy};
  };
  return {at(piece.from), at(piece.to)};
}

Split split(const std::vector<Piece>& members, std::span<const Approx> lines,
            const Margin& margin) {
  if (members.size() <= kFullBucket) return {};
  const PairSample pairs = look_at_pairs(members, lines, margin);
  if (pairs.pencil) return {};
  Split best = split_along(best_normal(members, lines, margin), members, lines, margin);
  const double count = static_cast<double>(members.size());
  best.useful = static_cast<double>(best.low.size() + best.high.size()) <
                (pairs.crossing > kDense ? kProgressIfDense : kProgress) * count;
  return best;
}

}  // namespace plumbline::bucket
