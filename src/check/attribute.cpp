// From findings to the stages that made them.

#include "check/attribute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "compare/wrong_cells.hpp"

namespace plumbline::check_steps {
namespace {

/// Broken invariants that say that edges meet where they should not; of edges or vertices alone.
bool is_about_line_work(const Finding& finding) {
  if (!finding.invariant) return false;
  switch (*finding.invariant) {
    case Invariant::Crossing:
    case Invariant::VertexOnEdge:
    case Invariant::DuplicateVertex:
    case Invariant::DuplicateEdge:
    case Invariant::Index:
      return true;
    default:
      return false;
  }
}

/// Whether pieces of the same segments meet where they should not there, too.
bool breaks_too(const Comparison& comparison, const Finding& finding) {
  if (finding.segments.empty()) return false;
  const std::size_t least = std::min<std::size_t>(finding.segments.size(), 2);
  return std::any_of(comparison.findings.begin(), comparison.findings.end(),
                     [&](const Finding& other) {
                       if (!is_about_line_work(other)) return false;
                       std::vector<SegmentId> common;
                       std::set_intersection(finding.segments.begin(), finding.segments.end(),
                                             other.segments.begin(), other.segments.end(),
                                             std::back_inserter(common));
                       return common.size() >= least;
                     });
}

using Ends = std::pair<PointD, PointD>;

Ends ends(const PointD& a, const PointD& b) { return std::minmax(a, b); }

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

bool is_of_conversion(const Cause& cause) {
  return cause.stage == kParse || cause.stage == kTransform;
}

class Attribution {
 public:
  Attribution(const Comparison& comparison, const ExactComplex& exact_complex,
              const FloatComplex& float_complex, const Run& run, const Converted& converted,
              std::size_t threads)
      : comparison_(comparison),
        findings_(comparison.findings),
        exact_(exact_complex),
        float_(float_complex),
        run_(run),
        converted_(converted),
        threads_(threads),
        outputs_(run.outputs()),
        is_cut_once_(std::any_of(outputs_.begin(), outputs_.end(),
                                 [](const StageOutput& output) { return output.is_cut; })),
        causes_(findings_.size()) {}

  std::vector<Cause> causes() && {
    if (!is_cut_once_) blame_invalid();
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      const bool is_of_cells = findings_[i].invariant && !is_about_line_work(findings_[i]);
      if (!causes_[i] && !is_of_cells) open_.push_back(i);
    }
    // A valid float complex is the exact one of the last line work.
    std::size_t k = outputs_.size() - 1;
    if (!comparison_.float_valid) close_absent(k);
    for (; k > 0 && !open_.empty(); --k) {
      if (outputs_[k].changed) close_absent(k - 1);
    }
    take_from_conversion();
    if (is_cut_once_) blame_invalid_cells();
    explain();
    run_without_owners();
    blame_suspects();
    std::vector<Cause> result;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      result.push_back(run_.refined(findings_[i], std::move(*causes_[i])));
    }
    return result;
  }

 private:
  /// The open findings that are not there when the output of stage k is continued exactly belong to
  /// the stage after it.
  void close_absent(std::size_t k);
  Cause owned_by(const Finding& finding, std::size_t owner) const;
  void blame_invalid();
  void blame_invalid_cells();
  std::size_t owner_of_invalid(const Finding& finding) const;
  bool take_correspondence(const std::vector<std::size_t>& findings) const {
    return std::any_of(findings.begin(), findings.end(), [&](std::size_t i) {
      return compare_steps::takes_correspondence(findings_[i]);
    });
  }
  /// The last output that changed something, up to k.
  std::size_t changed(std::size_t k) const;
  void take_from_conversion();
  void explain();
  void run_without_owners();
  void run_without(const std::string& stage, std::size_t round,
                   const std::vector<std::size_t>& findings);
  void blame_suspects();

  const Comparison& comparison_;
  const std::vector<Finding>& findings_;
  const ExactComplex& exact_;
  const FloatComplex& float_;
  const Run& run_;
  const Converted& converted_;
  const std::size_t threads_;
  const std::vector<StageOutput> outputs_;
  const bool is_cut_once_;
  std::vector<std::optional<Cause>> causes_;  ///< per finding
  std::vector<std::size_t> open_;             ///< findings there from the stage looked at on
};

Cause Attribution::owned_by(const Finding& finding, std::size_t owner) const {
  Cause cause;
  if (owner < outputs_.size()) {
    cause.stage = outputs_[owner].stage;
    cause.round = outputs_[owner].round;
  } else {
    cause.stage = run_.late_stage(finding);
  }
  return cause;
}

std::size_t Attribution::changed(std::size_t k) const {
  while (!outputs_[k].changed) --k;
  return k;
}

void Attribution::close_absent(std::size_t k) {
  std::optional<Comparison> continued;
  if (const std::size_t with_work = changed(k); with_work > 0) {
    continued = compare_steps::compare_cells(exact_, run_.continued(outputs_[with_work], threads_),
                                             comparison_.tolerance, take_correspondence(open_));
  }
  const Comparison& there = continued ? *continued : converted_.comparison;
  const compare_steps::WrongCells wrong(there, exact_);
  std::erase_if(open_, [&](std::size_t i) {
    const Finding& finding = findings_[i];
    if (finding.invariant ? breaks_too(there, finding) : wrong.has(finding)) return false;
    causes_[i] = owned_by(finding, k + 1);
    causes_[i]->confirmed = true;
    return true;
  });
}

/// Edges that meet where they should not were left by the last cutting if it had them in this
/// place, else made by what came after it.
std::size_t Attribution::owner_of_invalid(const Finding& finding) const {
  std::set<Ends> bad;
  if (finding.kind == CellKind::Edge) {
    for (const std::size_t e : finding.float_cells) {
      bad.insert(
          ends(float_.vertices[float_.edges[e].tail], float_.vertices[float_.edges[e].head]));
    }
  }
  std::size_t owner = outputs_.size() - 1;
  for (std::size_t k = outputs_.size() - 1; k > 0; --k) {
    if (!outputs_[k].cuts) continue;
    std::set<Ends> here;
    for (const SegmentD& s : outputs_[changed(k)].work.segments) {
      if (const Ends e = ends(s.a, s.b); bad.contains(e)) here.insert(e);
    }
    if (here.size() < bad.size() || bad.empty()) break;
    owner = k;
  }
  return owner;
}

void Attribution::blame_invalid() {
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    if (is_about_line_work(findings_[i])) {
      causes_[i] = owned_by(findings_[i], owner_of_invalid(findings_[i]));
    }
  }
  blame_invalid_cells();
}

/// Where edges cross, cycles and nesting mean nothing; else they are wrong by themselves.
void Attribution::blame_invalid_cells() {
  const auto of_lines = std::find_if(findings_.begin(), findings_.end(), is_about_line_work);
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    if (findings_[i].disagreement != Disagreement::Invalid || causes_[i]) continue;
    causes_[i] = of_lines != findings_.end()
                     ? causes_[static_cast<std::size_t>(of_lines - findings_.begin())]
                     : owned_by(findings_[i], outputs_.size());
  }
}

/// What is left was there in the rounded input already.
void Attribution::take_from_conversion() {
  const compare_steps::WrongCells wrong(converted_.comparison, exact_);
  for (const std::size_t i : open_) {
    const auto same = wrong.same(findings_[i]);
    causes_[i] = same ? converted_.causes[*same] : owned_by(findings_[i], 0);
  }
  open_.clear();
}

/// A finding that follows from an earlier one of the same stage has the earlier one's rule.
void Attribution::explain() {
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    Cause& cause = *causes_[i];
    if (!cause.rule.empty()) continue;
    for (const std::size_t number : findings_[i].because) {
      const Cause& earlier = *causes_[number - 1];
      if (earlier.stage != cause.stage || earlier.round != cause.round) continue;
      cause = earlier;
      break;
    }
    if (cause.rule.empty()) cause = run_.explained(findings_[i], std::move(cause));
  }
}

/// Replaces each stage that owns findings by the exact one, once, and lets the later ones run.
void Attribution::run_without_owners() {
  if (exact_.edge_count() > kMostEdgesRunAgain && comparison_.float_valid) return;
  std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> by_stage;
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    if (!is_of_conversion(*causes_[i])) {
      by_stage[{causes_[i]->stage, causes_[i]->round}].push_back(i);
    }
  }
  for (const auto& [place, findings] : by_stage) run_without(place.first, place.second, findings);
}

void Attribution::run_without(const std::string& stage, std::size_t round,
                              const std::vector<std::size_t>& findings) {
  const std::optional<FloatComplex> replaced = run_.with_exact(stage, round);
  if (!replaced) return;
  const bool with_correspondence =
      replaced->edge_count() <= kMostEdgesRunAgain && take_correspondence(findings);
  const Comparison now =
      compare_steps::compare_cells(exact_, *replaced, comparison_.tolerance, with_correspondence);
  const compare_steps::WrongCells wrong(now, exact_);
  for (const std::size_t i : findings) {
    Cause& cause = *causes_[i];
    const bool is_known = with_correspondence || !compare_steps::takes_correspondence(findings_[i]);
    if (findings_[i].disagreement == Disagreement::Invalid) {
      cause.remade = !now.float_valid;
      if (!is_cut_once_ || now.float_valid) cause.confirmed = now.float_valid;
    } else if (is_known) {
      cause.remade = wrong.has(findings_[i]);
    }
  }
}

/// A finding belongs to the stage that the run suspects, if it goes away where that one is exact.
void Attribution::blame_suspects() {
  std::map<std::string, std::vector<std::size_t>> by_suspect;
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    if (const auto suspect = run_.suspect(*causes_[i])) by_suspect[*suspect].push_back(i);
  }
  for (const auto& [suspect, findings] : by_suspect) {
    const auto replaced = run_.with_exact(suspect, 0);
    if (!replaced) continue;
    const Comparison now = compare_steps::compare_cells(exact_, *replaced, comparison_.tolerance,
                                                        take_correspondence(findings));
    const compare_steps::WrongCells wrong(now, exact_);
    for (const std::size_t i : findings) {
      if (wrong.has(findings_[i])) continue;
      Cause cause;
      cause.stage = suspect;
      cause.confirmed = true;
      cause.remade = false;
      causes_[i] = run_.explained(findings_[i], std::move(cause));
    }
  }
}

/// "vertex-merged", "hole-wrong-parent"; of invalid results the broken invariant: "crossing".
std::string rule_of(const Finding& finding) {
  std::string rule = finding.invariant
                         ? to_text(*finding.invariant)
                         : to_text(finding.kind) + '-' + to_text(finding.disagreement);
  std::replace(rule.begin(), rule.end(), ' ', '-');
  return rule;
}

}  // namespace

std::vector<Cause> attribute(const Comparison& comparison, const ExactComplex& exact_complex,
                             const FloatComplex& float_complex, const Run& run,
                             const Converted& converted, std::size_t threads) {
  if (comparison.agree()) return {};
  return Attribution(comparison, exact_complex, float_complex, run, converted, threads).causes();
}

std::vector<Cause> attribute_conversion(const Comparison& conversion, const Comparison* parsed,
                                        const ExactComplex& exact_complex) {
  std::optional<compare_steps::WrongCells> wrong;
  if (parsed) wrong.emplace(*parsed, exact_complex);
  std::vector<Cause> causes;
  for (const Finding& finding : conversion.findings) {
    const bool by_parsing = !wrong || wrong->has(finding);
    causes.push_back(by_parsing ? parsing() : transforming());
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
    if (const auto same = is_invalid ? std::nullopt : wrong.same(finding)) {
      causes.push_back(converted.causes[*same]);
      continue;
    }
    Cause cause;
    cause.stage = engine;
    cause.rule = rule_of(finding);
    cause.explanation = "rounding the drawing to doubles does not make it: its maker did";
    if (finding.distance && *finding.distance > 0 && !is_invalid) {
      cause.advice = fmt::format("a tolerance or grid below {:.3g} there", *finding.distance);
    }
    causes.push_back(std::move(cause));
  }
  return causes;
}

}  // namespace plumbline::check_steps
