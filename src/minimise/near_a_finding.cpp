// A few segments around one finding instead of all: most faults are local.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {
namespace {

constexpr std::size_t kMostFindings = 4;  ///< whose surroundings are tried
constexpr std::size_t kMostOthers = 16;   ///< of other kinds
constexpr std::size_t kLeastNear = 4;     ///< segments; then twice as many, and so on

double distance(const PointD& p, const Line& line) {
  const auto& [ax, ay, bx, by] = line.numbers;
  const double dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
  const double along = length == 0 ? 0 : ((p.x - ax) * dx + (p.y - ay) * dy) / length;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - (ax + t * dx), p.y - (ay + t * dy));
}

/// The lines of these indices, in their order.
Lines chosen(const Lines& lines, std::vector<std::size_t> indices) {
  std::ranges::sort(indices);
  Lines result;
  for (const std::size_t i : indices) {
    if (i < lines.size()) result.push_back(lines[i]);
  }
  return result;
}

/// From the nearest to the place to the furthest.
std::vector<std::size_t> by_distance(const Lines& lines, const PointD& place) {
  std::vector<double> far;
  for (const Line& line : lines) far.push_back(distance(place, line));
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return far[i]; });
  return order;
}

/// Findings that have a place, of the sought kind; where that has none, some of all others.
std::vector<const Finding*> findings_to_try(const Check& check, const Outcome& sought) {
  std::vector<const Finding*> of_kind, others;
  for (const Finding& finding : check.comparison.findings) {
    if (finding.kind == CellKind::Complex) continue;
    Check alone;
    alone.comparison.findings = {finding};
    (is_same(outcome(alone), sought) ? of_kind : others).push_back(&finding);
  }
  if (!of_kind.empty()) {
    of_kind.resize(std::min(of_kind.size(), kMostFindings));
    return of_kind;
  }
  std::vector<const Finding*> some;
  const std::size_t step = others.size() / kMostOthers + 1;
  for (std::size_t i = 0; i < others.size(); i += step) some.push_back(others[i]);
  return some;
}

}  // namespace

Lines near_a_finding(const Lines& lines, Trials& trials) {
  if (lines.size() <= kLeastNear || trials.have_ended()) return lines;
  const Check check = trials.checked(lines, false);
  std::vector<std::vector<std::size_t>> surroundings;
  for (const Finding* finding : findings_to_try(check, trials.sought())) {
    const std::vector<std::size_t> named(finding->segments.begin(), finding->segments.end());
    if (!named.empty() && named.size() < lines.size()) {
      const Lines few = chosen(lines, named);
      if (trials.show(few)) return few;
    }
    surroundings.push_back(by_distance(lines, nearest(finding->where)));
  }
  for (std::size_t count = kLeastNear; count < lines.size(); count *= 2) {
    for (const auto& order : surroundings) {
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
      const Lines few = chosen(lines, {order.begin(), end});
      if (trials.show(few)) return few;
    }
  }
  return lines;
}

}  // namespace plumbline::minimise_steps
