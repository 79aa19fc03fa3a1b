// Everything here is said again from the definitions, with what is public.

#include "campaign/claims.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include "campaign/dice.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::campaign {
namespace {

/// Vertices that only the answer has are the same if they are within so many tolerances.
constexpr double kReach = 4;

std::optional<double> any_radius(const ExactComplex& complex, Dice& dice) {
  constexpr std::array kFactors = {0.1, 0.5, 0.999, 1.0, 1.001, 1.5, 3.0, 30.0};
  if (dice.one_in(6)) return std::nullopt;
  if (dice.one_in(6)) return 0;
  const ToleranceLadder ladder = tolerance_ladder(complex, {});
  if (ladder.steps.empty()) return std::nullopt;
  const LadderStep& step = ladder.steps[static_cast<std::size_t>(
      dice.pick(std::min<std::size_t>(ladder.steps.size(), 5)))];
  return nearest_sqrt(step.squared_radius) *
         kFactors[static_cast<std::size_t>(dice.pick(kFactors.size()))];
}

bool contains(const std::vector<std::size_t>& cells, std::size_t cell) {
  return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

bool share(const std::vector<std::size_t>& cells, const std::vector<std::size_t>& others) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](std::size_t cell) { return contains(others, cell); });
}

bool has_common(const std::vector<SegmentId>& segments, const std::vector<SegmentId>& others) {
  return std::find_first_of(segments.begin(), segments.end(), others.begin(), others.end()) !=
         segments.end();
}

bool is_invalid(const Finding& finding) { return finding.disagreement == Disagreement::Invalid; }

/// Whether the other finding is about a part of the same.
bool is_about(const Finding& finding, const Finding& other, double tolerance) {
  if (is_invalid(other) || other.kind != finding.kind) return false;
  if (!finding.exact_cells.empty()) return share(finding.exact_cells, other.exact_cells);
  if (!other.exact_cells.empty()) return false;
  const bool is_common = has_common(finding.segments, other.segments);
  if (!is_common || finding.kind != CellKind::Vertex || tolerance == 0) return is_common;
  return nearest_sqrt(squared_distance(finding.where, other.where)) <= kReach * tolerance;
}

bool has_part(const Comparison& comparison, const Finding& finding) {
  return std::any_of(
      comparison.findings.begin(), comparison.findings.end(),
      [&](const Finding& other) { return is_about(finding, other, comparison.tolerance); });
}

/// Whether the other finding is the same, of the same cells.
bool is_alike(const Finding& finding, const Finding& other) {
  return other.kind == finding.kind && other.disagreement == finding.disagreement &&
         other.exact_cells.size() == finding.exact_cells.size() &&
         other.float_cells.size() == finding.float_cells.size() &&
         std::all_of(finding.exact_cells.begin(), finding.exact_cells.end(),
                     [&](std::size_t cell) { return contains(other.exact_cells, cell); });
}

bool has_whole(const Comparison& comparison, const Finding& finding) {
  if (finding.exact_cells.empty()) return has_part(comparison, finding);
  return std::any_of(comparison.findings.begin(), comparison.findings.end(),
                     [&](const Finding& other) { return is_alike(finding, other); });
}

bool is_of_conversion(const Cause& cause) {
  return cause.stage == kParse || cause.stage == kTransform;
}

class Claims {
 public:
  explicit Claims(const Check& check)
      : check_(check), run_(check.answer.trace()), outputs_(run_->outputs()) {}

  std::string refuted() {
    for (std::size_t i = 0; i < check_.causes.size(); ++i) {
      const Finding& finding = check_.comparison.findings[i];
      const Cause& cause = check_.causes[i];
      for (const std::string& wrong :
           {refuted_advice(finding, cause), refuted_cause(finding, cause),
            refuted_rounding(finding, cause), refuted_drift(finding, cause)}) {
        if (!wrong.empty()) return wrong;
      }
    }
    return "";
  }

 private:
  std::string refuted_advice(const Finding& finding, const Cause& cause);
  std::string refuted_cause(const Finding& finding, const Cause& cause);
  std::string refuted_rounding(const Finding& finding, const Cause& cause);
  bool is_blamed(const Finding& of_doubles) const;
  std::vector<bool> accounted_for(const Comparison& of_doubles) const;
  std::string refuted_drift(const Finding& finding, const Cause& cause) const;

  bool is_there_with(double radius, const Finding& finding) {
    const auto known = runs_.find(radius);
    const Comparison& now = known != runs_.end() ? known->second : run_with(radius);
    return is_invalid(finding) ? !now.float_valid : has_part(now, finding);
  }
  const Comparison& run_with(double radius) {
    const Answer answer = answer_of(lar::engine(), check_.input, {{"radius", radius}}, 1);
    return runs_[radius] = compare(check_.exact_complex, answer.complex, *answer.radius);
  }
  /// With the output of the stage at this place continued exactly. Past the last one: the answer.
  const Comparison& continued(std::size_t place) {
    if (place >= outputs_.size()) return check_.comparison;
    while (!outputs_[place].changed) --place;
    const auto known = continued_.find(place);
    if (known != continued_.end()) return known->second;
    return continued_[place] = compare(check_.exact_complex, run_->continued(outputs_[place], 1),
                                       check_.comparison.tolerance);
  }
  std::size_t place(const Cause& cause) const {
    if (is_of_conversion(cause)) return 0;
    std::size_t k = 1;
    while (k < outputs_.size() &&
           (outputs_[k].stage != cause.stage || outputs_[k].round != cause.round)) {
      ++k;
    }
    return k;
  }

  const Check& check_;
  const std::shared_ptr<const Run> run_;
  const std::vector<StageOutput> outputs_;
  std::map<double, Comparison> runs_;
  std::optional<Comparison> of_doubles_;  ///< the answer held against the doubles
  std::vector<bool> is_known_;            ///< of its findings
  std::map<std::size_t, Comparison> continued_;
};

/// The number after the words; none without them.
std::optional<double> number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) return std::nullopt;
  return std::strtod(text.c_str() + at + words.size(), nullptr);
}

std::string Claims::refuted_advice(const Finding& finding, const Cause& cause) {
  if (cause.advice.find("a radius below") != std::string::npos) return "advice that nobody tried";
  const auto said = number_after(cause.advice, "with radius ");
  if (said && said != cause.radius_without) return "the advice has another radius than was tried";
  if (cause.radius_without && is_there_with(*cause.radius_without, finding)) {
    return "with the radius that is advised the finding is there";
  }
  const bool denies = cause.advice.find("with the least radius") != std::string::npos;
  if (denies && !is_there_with(0, finding)) return "with the least radius the finding is not there";
  return "";
}

std::string Claims::refuted_cause(const Finding& finding, const Cause& cause) {
  if (!cause.confirmed || cause.stage == kDrawing) return "";
  if (is_invalid(finding)) {
    const auto replaced = run_->with_exact(cause.stage, cause.round);
    const bool is_valid = replaced && validate(exact(*replaced)).empty();
    return is_valid ? "" : "without the stage that is to blame the result is invalid, too";
  }
  const auto is_first = [&](const Cause& one) {
    const std::size_t k = place(one);
    return k == 0 || !has_part(continued(k - 1), finding);
  };
  std::size_t last = place(cause);
  for (const Cause& other : cause.with) last = std::max(last, place(other));
  if (!is_first(cause) && std::none_of(cause.with.begin(), cause.with.end(), is_first)) {
    return "there is a part of the finding before the stages that are to blame";
  }
  if (!has_whole(continued(last), finding)) {
    return "the finding is not all there after the stages that are to blame";
  }
  return "";
}

/// Whether the engine is to blame for such a finding at the same cells of its answer, or, where it
/// left none, of the same segments.
bool Claims::is_blamed(const Finding& of_doubles) const {
  for (std::size_t i = 0; i < check_.causes.size(); ++i) {
    const Finding& finding = check_.comparison.findings[i];
    const Cause& cause = check_.causes[i];
    if (is_of_conversion(cause) && cause.with.empty()) continue;
    if (finding.kind != of_doubles.kind || finding.disagreement != of_doubles.disagreement)
      continue;
    const bool has_cells = !finding.float_cells.empty() || !of_doubles.float_cells.empty();
    if (has_cells ? share(finding.float_cells, of_doubles.float_cells)
                  : has_common(finding.segments, of_doubles.segments)) {
      return true;
    }
  }
  return false;
}

/// Which findings about the doubles are accounted for: the engine is to blame for such a finding,
/// or changed nothing but what rounding had made wrong, or both are true of what it follows from.
std::vector<bool> Claims::accounted_for(const Comparison& of_doubles) const {
  std::array<std::vector<std::size_t>, 5> wrong;  // per kind
  for (const Finding& made : check_.conversion.findings) {
    auto& cells = wrong[static_cast<std::size_t>(made.kind)];
    cells.insert(cells.end(), made.float_cells.begin(), made.float_cells.end());
  }
  std::vector<bool> result;
  for (const Finding& f : of_doubles.findings) {
    const auto& cells = wrong[static_cast<std::size_t>(f.kind)];
    const auto is_wrong = [&](std::size_t cell) { return contains(cells, cell); };
    const auto is_known = [&](std::size_t number) { return result[number - 1]; };
    const bool is_mended = f.because.empty()
                               ? std::all_of(f.exact_cells.begin(), f.exact_cells.end(), is_wrong)
                               : std::all_of(f.because.begin(), f.because.end(), is_known);
    result.push_back(is_mended || is_blamed(f));
  }
  return result;
}

/// Rounding alone is to blame, but the engine does such a thing to the doubles, too.
std::string Claims::refuted_rounding(const Finding& finding, const Cause& cause) {
  if (!is_of_conversion(cause) || !cause.with.empty() || is_invalid(finding)) return "";
  std::vector<std::size_t> cells;  // of the doubles
  for (const Finding& other : check_.conversion.findings) {
    if (!is_alike(finding, other)) continue;
    cells.insert(cells.end(), other.float_cells.begin(), other.float_cells.end());
  }
  if (!of_doubles_) {
    of_doubles_ =
        compare(check_.doubles_complex, check_.answer.complex, check_.comparison.tolerance);
    is_known_ = accounted_for(*of_doubles_);
  }
  for (std::size_t i = 0; i < of_doubles_->findings.size(); ++i) {
    const Finding& other = of_doubles_->findings[i];
    if (other.kind == finding.kind && other.disagreement == finding.disagreement &&
        share(other.exact_cells, cells) && !is_known_[i]) {
      return "rounding alone is to blame, but the engine does it to the doubles, too";
    }
  }
  return "";
}

/// Vertices that the drawing's digits are to blame for are of one place of the drift, or beside an
/// edge.
std::string Claims::refuted_drift(const Finding& finding, const Cause& cause) const {
  if (cause.stage != kDrawing || finding.kind != CellKind::Vertex) return "";
  constexpr const char* kWrong = "the drawing's digits are to blame for a vertex they do not move";
  const Drift& drift = check_.drift;
  if (drift.stands_for.empty()) return kWrong;
  const auto stands_for = [&](std::size_t v) { return drift.stands_for[v]; };
  std::vector<std::size_t> lone;
  for (const std::size_t v : finding.exact_cells) {
    const auto is_of_place = [&](std::size_t w) {
      return w != v && stands_for(w) == stands_for(v);
    };
    bool is_known = std::any_of(drift.beside.begin(), drift.beside.end(),
                                [&](const auto& pair) { return pair.second == v; });
    for (std::size_t w = 0; w < drift.stands_for.size(); ++w) is_known |= is_of_place(w);
    if (!is_known) lone.push_back(v);
  }
  const bool is_merged = finding.disagreement == Disagreement::Merged;
  const bool is_one_place = std::all_of(
      finding.exact_cells.begin(), finding.exact_cells.end(),
      [&](std::size_t v) { return stands_for(v) == stands_for(finding.exact_cells.front()); });
  const bool is_right = is_merged ? is_one_place : lone.empty();
  return is_right ? "" : kWrong;
}

}  // namespace

std::string refuted_claim(const SegmentSet& input, const ExactComplex& complex,
                          std::uint64_t seed) {
  Dice dice(seed);
  Parameters parameters;
  if (const auto radius = any_radius(complex, dice)) parameters["radius"] = *radius;
  CheckOptions options;
  options.threads = 1;
  const Check checked =
      check(input, complex, answer_of(lar::engine(), input, parameters, 1), options);
  return refuted_claim(checked);
}

std::string refuted_claim(const Check& check) { return Claims(check).refuted(); }

}  // namespace plumbline::campaign
