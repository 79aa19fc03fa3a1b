// The ladder says where right radii should end: at the first critical one, at which something
// merges that is exactly apart. Where they begin (rounding takes apart what is one) only trying
// tells.

#include "check/right_radii.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "check/without_drift.hpp"
#include "plumbline/error.hpp"

namespace plumbline::check_steps {
namespace {

// Radii are tried this factor below and above a critical one.
constexpr double kBeside = 1.005;
// Where right radii end is found to this factor: no less than from below to above.
constexpr double kResolution = 1.0101;
// So many radii at least, if they are apart: two right ones say little about those between them.
constexpr std::size_t kLeastTrials = 6;

class Trials {
 public:
  Trials(const Check& check, const AdviceOptions& options)
      : check_(check),
        exact_(check.exact_complex),
        tolerance_(check.comparison.tolerance == check.answer.radius
                       ? std::nullopt
                       : std::optional(check.comparison.tolerance)),
        options_(options) {}

  /// Whether the search may: one run is left for what is advised.
  bool may_go_on() const { return runs_ + 1 < options_.max_runs; }
  bool may_run() const { return runs_ < options_.max_runs; }
  const std::vector<TriedRadius>& tried() const { return tried_; }

  /// Whether the answer is right; the radius is recorded as the engine raises it.
  bool is_right(double radius) {
    const double done = static_cast<double>(runs_) / static_cast<double>(options_.max_runs);
    if (options_.progress && !options_.progress(done)) {
      throw Error(ErrorCode::Cancelled, "the search for right radii was cancelled");
    }
    ++runs_;
    return record(run(radius));
  }

  /// What is known without another run.
  bool record(const TriedRadius& trial) {
    const auto place = std::find_if(tried_.begin(), tried_.end(), [&](const TriedRadius& other) {
      return other.radius >= trial.radius;
    });
    if (place == tried_.end() || place->radius != trial.radius) tried_.insert(place, trial);
    return trial.is_right;
  }

  /// Tries radii between tried ones of different outcome until these are near each other.
  void bisect() {
    while (may_go_on()) {
      const auto gap = std::adjacent_find(
          tried_.begin(), tried_.end(), [](const TriedRadius& low, const TriedRadius& high) {
            return low.is_right != high.is_right && high.radius > low.radius * kResolution;
          });
      if (gap == tried_.end() || !try_between(gap)) return;
    }
  }

  /// Tries the middles of the widest gaps below a radius: to find a right one if there is none,
  /// else until there are kLeastTrials.
  void fill(double below) {
    while (may_go_on()) {
      if (tried_.size() >= kLeastTrials) return;
      auto widest = tried_.end();
      double ratio = kResolution;
      for (auto low = tried_.begin(); std::next(low) != tried_.end(); ++low) {
        const double high = std::next(low)->radius;
        if (high > below || high <= low->radius * ratio) continue;
        ratio = high / low->radius;
        widest = low;
      }
      if (widest == tried_.end() || !try_between(widest)) return;
    }
  }

 private:
  TriedRadius run(double radius) {
    try {
      const auto [complex, used] =
          check_.answer.with_radius(check_.input, radius, options_.threads);
      // Of the first one, the least there is, what is left is told in any case.
      if (runs_ > 1 && !may_be_right(complex)) return {used, false};
      const std::size_t left = findings_left(compare(exact_, complex, tolerance_.value_or(used)));
      return {used, left == 0, left};
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Limit) return {radius, false};
      throw;
    }
  }

  /// By its numbers of cells: those of the exact complex, or, where that has drift, no more
  /// vertices gone than the drift takes.
  bool may_be_right(const FloatComplex& complex) const {
    if (check_.drift.places == 0) {
      return counts(complex, complex.vertices.size()) == counts(exact_, exact_.vertices.size());
    }
    const std::size_t here = exact_.vertices.size(), there = complex.vertices.size();
    return (here > there ? here - there : there - here) <= vertices_in_drift(check_.drift);
  }

  /// Those that are not the drawing's own.
  std::size_t findings_left(const Comparison& comparison) {
    if (comparison.agree() || check_.drift.places == 0) return comparison.findings.size();
    if (!without_drift_) {
      without_drift_ = without_drift(check_.input, exact_, check_.drift, options_.threads);
    }
    return findings_beside_drift(comparison, exact_, *without_drift_, check_.drift);
  }

  /// The geometric middle of a tried radius and the next one. False if there is none.
  bool try_between(std::vector<TriedRadius>::const_iterator low) {
    const double least = low->radius, most = std::next(low)->radius;
    const double middle = std::sqrt(least) * std::sqrt(most);
    if (!(middle > least && middle < most)) return false;
    is_right(middle);
    return true;
  }

  const Check& check_;
  const ExactComplex& exact_;
  const std::optional<double>
      tolerance_;  ///< where the user chose one; else each radius is its own
  const AdviceOptions& options_;
  std::vector<TriedRadius> tried_;  ///< ascending
  std::size_t runs_ = 0;
  std::optional<ExactComplex> without_drift_;  ///< made when first asked for
};

/// A number of one digit well between the two, if there is one.
std::optional<double> one_digit_between(double least, double largest) {
  const double middle = std::sqrt(least) * std::sqrt(largest);
  const double rounded = std::strtod(fmt::format("{:.0e}", middle).c_str(), nullptr);
  return least < rounded && rounded < largest ? std::optional(rounded) : std::nullopt;
}

/// The longest run (by the ratio of its ends, then the first) of right radii.
RightRadii longest_run(const std::vector<TriedRadius>& tried) {
  const auto is_right = [](const TriedRadius& trial) { return trial.is_right; };
  RightRadii result{0, 0, tried};
  double longest = 0;
  for (auto first = tried.begin();
       (first = std::find_if(first, tried.end(), is_right)) != tried.end();) {
    const auto last = std::find_if_not(first, tried.end(), is_right);
    const double ratio = std::prev(last)->radius / first->radius;
    if (ratio > longest) {
      longest = ratio;
      result.least = first->radius;
      result.largest = std::prev(last)->radius;
    }
    first = last;
  }
  return result;
}

}  // namespace

RightRadii right_radii(const Check& check, const AdviceOptions& options) {
  Trials trials(check, options);
  trials.is_right(0);  // raised to the least radius there is
  if (check.answer.radius) {
    const std::size_t left = check.comparison.findings.size() - check.own_findings();
    trials.record({*check.answer.radius, left == 0, left});
  }
  const double least = trials.tried().front().radius;
  std::optional<double> first;  // critical radius that the engine can tell
  for (const LadderStep& step : check.ladder->steps) {
    const double critical = nearest_sqrt(step.squared_radius);
    if (critical <= least) continue;
    if (!first) first = critical;
    if (critical / kBeside > least && trials.may_go_on()) trials.is_right(critical / kBeside);
    // Beyond it something has merged. If the result is right all the same, go on with the ladder.
    if (!trials.may_go_on() || !trials.is_right(critical * kBeside)) break;
  }
  trials.bisect();
  if (first) trials.fill(*first);
  trials.bisect();
  RightRadii result = longest_run(trials.tried());
  if (result.empty()) return result;
  const auto advised = one_digit_between(result.least, result.largest);
  if (!advised || !trials.may_run() || !trials.is_right(*advised)) {
    result.advised = result.largest;
    return result;
  }
  result = longest_run(trials.tried());
  result.advised = advised;
  return result;
}

}  // namespace plumbline::check_steps
