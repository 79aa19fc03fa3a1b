// The list of steps, again until nothing changes.

#include "plumbline/minimise.hpp"

#include "minimise/steps.hpp"
#include "plumbline/round.hpp"

namespace plumbline {
namespace {

using namespace minimise_steps;

/// Numbers are made simple where a trial is cheap.
constexpr std::size_t kMostWithSimpleNumbers = 100;

Lines reduced(Lines lines, Trials& trials) {
  for (Lines before; before != lines && !trials.have_ended();) {
    before = lines;
    lines = in_own_order(lines, trials);
    lines = near_a_finding(lines, trials);
    lines = fewest(std::move(lines), trials);
    if (lines.size() > kMostWithSimpleNumbers) continue;
    lines = simpler_together(std::move(lines), trials);
    lines = simpler_one_by_one(std::move(lines), trials);
  }
  return lines;
}

/// The radius, where the engine chose it itself.
std::optional<double> chosen_radius(const Check& check, const Parameters& parameters) {
  return parameters.contains("radius") ? std::nullopt : check.answer.radius;
}

}  // namespace

Minimised minimised(const SegmentSet& input, const Engine& engine, const Parameters& parameters,
                    const MinimiseOptions& options) {
  Trials trials(input, engine, parameters, options);
  Lines lines = lines_of(input);
  Minimised result;
  result.engine = engine.name;
  result.parameters = parameters;
  result.segments_before = input.segments.size();
  result.check = trials.checked(lines, false);
  result.outcome = outcome(result.check);
  result.is_representable = is_kept_by_simple_rounding(result.check.exact_complex, {});
  if (result.outcome.outcome_class != OutcomeClass::Right) {
    const auto radius = chosen_radius(result.check, parameters);
    trials.seek(result.outcome, result.is_representable);
    lines = reduced(std::move(lines), trials);
    result.is_one_minimal = !trials.have_ended();
    result.has_simple_numbers = result.is_one_minimal && lines.size() <= kMostWithSimpleNumbers;
    result.check = trials.checked(lines, true);
    result.outcome = outcome(result.check);
    result.is_representable = is_kept_by_simple_rounding(result.check.exact_complex, {});
    result.holds_in_decimals = trials.show_in_decimals(lines);
    if (radius && radius != chosen_radius(result.check, parameters)) result.radius_before = radius;
  }
  result.drawing = drawing_of(lines, input);
  result.runs = trials.runs();
  return result;
}

}  // namespace plumbline
