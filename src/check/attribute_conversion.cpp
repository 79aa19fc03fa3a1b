// What rounding to doubles made, and what whoever made an answer that can't be looked into did.

#include <algorithm>

#include "check/attribute.hpp"
#include "compare/wrong_cells.hpp"

namespace plumbline::check_steps {
namespace {

Cause parsing() {
  Cause cause;
  cause.stage = kParse;
  cause.rule = "decimal-to-double";
  cause.explanation = "numbers of the file became the nearest doubles";
  cause.advice = "read the numbers as decimals, or draw on a grid of binary fractions";
  cause.confirmed = true;
  return cause;
}

Cause transforming() {
  Cause cause;
  cause.stage = kTransform;
  cause.rule = "transformed-to-double";
  cause.explanation = "coordinates that maps gave became the nearest doubles";
  cause.advice = "apply the maps exactly, or after the arrangement";
  cause.confirmed = true;
  return cause;
}

/// "vertex-merged", "hole-wrong-parent"; of invalid results the broken invariant: "crossing".
std::string rule_of(const Finding& finding) {
  std::string rule = finding.invariant
                         ? to_text(*finding.invariant)
                         : to_text(finding.kind) + '-' + to_text(finding.disagreement);
  std::replace(rule.begin(), rule.end(), ' ', '-');
  return rule;
}

/// The cause where rounding made a part of the finding: both.
Cause with(Cause cause, const Cause& other) {
  cause.with = {other};
  cause.with.front().with.clear();
  return cause;
}

}  // namespace

std::vector<Cause> attribute_conversion(const Comparison& conversion, const Comparison* parsed,
                                        const ExactComplex& exact_complex) {
  std::optional<compare_steps::WrongCells> wrong;
  if (parsed) wrong.emplace(*parsed, exact_complex);
  std::vector<Cause> causes;
  for (const Finding& finding : conversion.findings) {
    const std::size_t whole = compare_steps::WrongCells::whole(finding);
    const std::size_t extent = wrong ? wrong->extent(finding) : whole;
    if (extent == whole) {
      causes.push_back(parsing());
    } else {
      causes.push_back(extent > 0 ? with(transforming(), parsing()) : transforming());
    }
  }
  return causes;
}

std::vector<Cause> attribute_to_engine(const Comparison& comparison, const std::string& engine,
                                       const ExactComplex& exact_complex,
                                       const Converted& converted) {
  const compare_steps::WrongCells wrong(converted.comparison, exact_complex);
  std::vector<Cause> causes;
  for (const Finding& finding : comparison.findings) {
    const bool is_invalid = finding.disagreement == Disagreement::Invalid;
    const auto same = is_invalid ? std::nullopt : wrong.same(finding);
    if (same && wrong.extent(finding) == wrong.whole(finding)) {
      causes.push_back(converted.causes[*same]);
      continue;
    }
    Cause cause;
    cause.stage = engine;
    cause.rule = rule_of(finding);
    cause.explanation =
        same ? "rounding the drawing to doubles makes a part of it: its maker did the rest"
             : "rounding the drawing to doubles does not make it: its maker did";
    // Which rounding would do to a single face, nobody looked at.
    if (comparison.compared == Compared::SomeFaces) cause.explanation = "no face is bounded so";
    if (finding.distance && !is_invalid) cause.distance = finding.distance;
    causes.push_back(same ? with(std::move(cause), converted.causes[*same]) : std::move(cause));
  }
  return causes;
}

}  // namespace plumbline::check_steps
