// What is advised was tried: runs of the engine with smaller radii, shared by all findings.

#include "check/try_radii.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>

#include "check/attribute.hpp"
#include "compare/wrong_cells.hpp"
#include "plumbline/error.hpp"

namespace plumbline::check_steps {
namespace {

/// So many radii at first, of large drawings (kMostEdgesRunAgain) and of others; more of them say
/// more exactly which radius a finding takes.
constexpr std::size_t kFewQuantiles = 2, kQuantiles = 5;
/// So many more where findings are left; between radii only for more than this part of all.
constexpr std::size_t kMoreTrials = 3;
constexpr double kFew = 0.01;
/// Three digits are off by at most this part of a number.
constexpr double kHalfUnit = 0.005;

/// The number of three digits that is printed, no larger than this one.
double three_digits_below(double number) {
  const double rounded = std::strtod(fmt::format("{:.3g}", number).c_str(), nullptr);
  if (rounded <= number) return rounded;
  return std::strtod(fmt::format("{:.3g}", number * (1 - kHalfUnit)).c_str(), nullptr);
}

/// The least distance that the engine joined to make the finding.
std::optional<double> least_distance(const Cause& cause) {
  std::optional<double> least = cause.distance;
  for (const Cause& other : cause.with) {
    if (other.distance && (!least || *other.distance < *least)) least = other.distance;
  }
  return least;
}

bool is_of_engine(const Cause& cause) {
  return cause.stage != kDrawing && cause.stage != kParse && cause.stage != kTransform;
}

class RadiusTrials {
 public:
  RadiusTrials(Check& check, std::optional<double> tolerance, std::size_t threads)
      : check_(check),
        tolerance_(tolerance),
        threads_(threads),
        largest_(*check.answer.radius),
        quantiles_(check.exact_complex.edge_count() > kMostEdgesRunAgain ? kFewQuantiles
                                                                         : kQuantiles) {
    for (std::size_t i = 0; i < check.causes.size(); ++i) {
      if (is_of_engine(check.causes[i])) asked_.push_back(i);
    }
  }

  void run() && {
    if (asked_.empty()) return;
    for (const double radius : proposed()) absent_at(radius);
    conclude();
    std::vector<std::size_t> left;
    std::copy_if(asked_.begin(), asked_.end(), std::back_inserter(left),
                 [&](std::size_t i) { return !check_.causes[i].radius_without; });
    if (!left.empty()) search_down(left);
    conclude();
    for (const std::size_t i : asked_) advise(check_.causes[i]);
  }

 private:
  /// Quantiles of the radii just below what was joined, descending.
  std::vector<double> proposed() const {
    std::vector<double> all;
    for (const std::size_t i : asked_) {
      const auto distance = least_distance(check_.causes[i]);
      if (!distance) continue;
      const double radius = three_digits_below(*distance * (1 - kHalfUnit));
      if (radius < largest_) all.push_back(radius);
    }
    std::sort(all.begin(), all.end());
    std::vector<double> result = all;
    result.erase(std::unique(result.begin(), result.end()), result.end());
    if (result.size() > quantiles_) {
      result.clear();
      for (std::size_t q = 0; q < quantiles_; ++q) {
        result.push_back(all[q * all.size() / quantiles_]);
      }
      result.erase(std::unique(result.begin(), result.end()), result.end());
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  /// From the least radius there is upwards, by halving the digits between, for those of the
  /// findings that are not there with the least.
  void search_down(const std::vector<std::size_t>& findings) {
    if (!least_) absent_at(0);
    if (!least_ || *least_ >= largest_) return;
    const std::vector<std::size_t>& with_least = tried_.begin()->second;
    std::vector<std::size_t> wanted;
    std::set_intersection(findings.begin(), findings.end(), with_least.begin(), with_least.end(),
                          std::back_inserter(wanted));
    double low = *least_, high = tried_.size() > 1 ? std::next(tried_.begin())->first : largest_;
    const bool are_few =
        static_cast<double>(wanted.size()) < kFew * static_cast<double>(asked_.size());
    while (!wanted.empty() && !are_few && runs_ < quantiles_ + kMoreTrials) {
      const double middle = three_digits_below(std::sqrt(low) * std::sqrt(high));
      if (!(middle > low && middle < high)) return;
      const std::vector<std::size_t> absent = absent_at(middle);
      const bool all = std::includes(absent.begin(), absent.end(), wanted.begin(), wanted.end());
      (all ? low : high) = middle;
    }
  }

  /// The findings that are not there when the engine runs with this radius.
  std::vector<std::size_t> absent_at(double wanted);
  std::vector<std::size_t> absent_from(const RadiusTrial& trial) const;
  void conclude();
  void advise(Cause& cause) const;

  Check& check_;
  const std::optional<double> tolerance_;
  const std::size_t threads_;
  const double largest_;  ///< the radius of the answer, with which all are there
  const std::size_t quantiles_;
  std::vector<std::size_t> asked_;                    ///< the findings of the engine
  std::optional<double> least_;                       ///< that there is, where it was tried
  std::map<double, std::vector<std::size_t>> tried_;  ///< the findings that are not there
  std::size_t runs_ = 0;
};

std::vector<std::size_t> RadiusTrials::absent_at(double wanted) {
  ++runs_;
  RadiusTrial trial;
  try {
    trial = check_.answer.with_radius(check_.input, wanted, threads_);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Limit) return {};
    throw;
  }
  double radius = wanted;
  if (trial.radius > wanted || wanted == 0) {  // raised: as this number is
    least_ = trial.radius;
    radius = three_digits_below(trial.radius);
  }
  if (trial.radius >= largest_) return {};
  return tried_[radius] = absent_from(trial);
}

/// Down to no radius may the finding be there again: then what holds for two holds for both.
void RadiusTrials::conclude() {
  for (const std::size_t i : asked_) {
    std::optional<double>& without = check_.causes[i].radius_without;
    without.reset();
    for (const auto& [radius, absent] : tried_) {
      if (!std::binary_search(absent.begin(), absent.end(), i)) break;
      without = radius;
    }
  }
}

std::vector<std::size_t> RadiusTrials::absent_from(const RadiusTrial& trial) const {
  const std::vector<Finding>& findings = check_.comparison.findings;
  const bool with_correspondence = std::any_of(asked_.begin(), asked_.end(), [&](std::size_t i) {
    return compare_steps::takes_correspondence(findings[i]);
  });
  const Comparison now = compare_steps::compare_cells(
      check_.exact_complex, trial.complex, tolerance_.value_or(trial.radius), with_correspondence);
  const compare_steps::WrongCells wrong(now, check_.exact_complex);
  std::vector<std::size_t> absent;
  for (const std::size_t i : asked_) {
    const bool is_there = findings[i].invariant ? !now.float_valid : wrong.has(findings[i]);
    if (!is_there) absent.push_back(i);
  }
  return absent;
}

void RadiusTrials::advise(Cause& cause) const {
  if (!cause.advice.empty()) return;
  if (cause.radius_without) {
    cause.advice = fmt::format("with radius {:.3g} it is not there (tried)", *cause.radius_without);
  } else if (least_) {
    cause.advice =
        fmt::format("with the least radius that there is, {:.3g}, it is there too", *least_);
  }
}

}  // namespace

void try_radii(Check& check, std::optional<double> tolerance, std::size_t threads) {
  if (!check.answer.with_radius || !check.answer.radius || check.agree()) return;
  RadiusTrials(check, tolerance, threads).run();
}

}  // namespace plumbline::check_steps
