// From findings to the stages that made them.

#include "check/attribute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "compare/wrong_cells.hpp"
#include "engines/lar/explain/cells.hpp"

namespace plumbline::checking {
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
bool breaks_too(const Crosscheck& crosscheck, const Finding& finding) {
  if (finding.segments.empty()) return false;
  const std::size_t least = std::min<std::size_t>(finding.segments.size(), 2);
  return std::any_of(crosscheck.findings.begin(), crosscheck.findings.end(),
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
  cause.stage = Stage::Parse;
  cause.rule = "decimal-to-double";
  cause.explanation = "numbers of the file became the nearest doubles";
  cause.advice = "read the numbers as decimals, or draw on a grid of binary fractions";
  cause.confirmed = true;
  return cause;
}

Cause transforming() {
  Cause cause;
  cause.stage = Stage::Transform;
  cause.rule = "transformed-to-double";
  cause.explanation = "coordinates that maps gave became the nearest doubles";
  cause.advice = "apply the maps exactly, or after the arrangement";
  cause.confirmed = true;
  return cause;
}

class Attribution {
 public:
  Attribution(Crosscheck& result, const ExactComplex& exact_complex,
              const FloatComplex& float_complex, const TracedRun& run, const Crosscheck& conversion,
              std::size_t threads)
      : result_(result),
        exact_(exact_complex),
        float_(float_complex),
        run_(run),
        conversion_(conversion),
        threads_(threads),
        outputs_(run.outputs()),
        is_cut_once_(std::any_of(outputs_.begin(), outputs_.end(),
                                 [](const StageOutput& output) { return output.is_cut; })) {}

  void run() {
    if (!is_cut_once_) blame_invalid();
    for (std::size_t i = 0; i < result_.findings.size(); ++i) {
      const Finding& finding = result_.findings[i];
      const bool is_of_cells = finding.invariant && !is_about_line_work(finding);
      if (!finding.cause && !is_of_cells) open_.push_back(i);
    }
    // A valid float complex is the exact one of the last line work.
    std::size_t k = outputs_.size() - 1;
    if (!result_.float_valid) close_absent(k);
    for (; k > 0 && !open_.empty(); --k)
      if (outputs_[k].changed) close_absent(k - 1);
    take_from_conversion();
    if (is_cut_once_) blame_invalid_cells();
    explain();
    run_without_owners();
  }

 private:
  /// The open findings that are not there when the output of stage k is continued exactly belong to
  /// the stage after it.
  void close_absent(std::size_t k);
  ExactComplex continued_exactly(const StageOutput& output) const;
  void blame(Finding& finding, std::size_t owner);
  void blame_invalid();
  void blame_invalid_cells();
  std::size_t owner_of_invalid(const Finding& finding) const;
  /// The last output that changed something, up to k.
  std::size_t changed(std::size_t k) const;
  void take_from_conversion();
  void explain();
  void run_without_owners();

  Crosscheck& result_;
  const ExactComplex& exact_;
  const FloatComplex& float_;
  const TracedRun& run_;
  const Crosscheck& conversion_;
  const std::size_t threads_;
  const std::vector<StageOutput> outputs_;
  const bool is_cut_once_;
  std::vector<std::size_t> open_;  ///< findings there from the stage looked at on
};

void Attribution::blame(Finding& finding, std::size_t owner) {
  Cause cause;
  if (owner < outputs_.size()) {
    cause.stage = outputs_[owner].stage;
    cause.round = outputs_[owner].round;
  } else {
    cause.stage = run_.late_stage(finding);
  }
  finding.cause = cause;
}

std::size_t Attribution::changed(std::size_t k) const {
  while (!outputs_[k].changed) --k;
  return k;
}

void Attribution::close_absent(std::size_t k) {
  std::optional<Crosscheck> continued;
  if (const std::size_t with_work = changed(k); with_work > 0)
    continued = crosscheck(exact_, continued_exactly(outputs_[with_work]), result_.tolerance);
  const Crosscheck& there = continued ? *continued : conversion_;
  const WrongCells wrong(there, exact_);
  std::erase_if(open_, [&](std::size_t i) {
    const Finding& finding = result_.findings[i];
    if (finding.invariant ? breaks_too(there, finding) : wrong.has(finding)) return false;
    blame(result_.findings[i], k + 1);
    result_.findings[i].cause->confirmed = true;
    return true;
  });
}

ExactComplex Attribution::continued_exactly(const StageOutput& output) const {
  return output.is_cut ? cells_of(output.work, threads_) : arrange(output.work, threads_);
}

/// Edges that meet where they should not were left by the last cutting if it had them in this
/// place, else made by what came after it.
std::size_t Attribution::owner_of_invalid(const Finding& finding) const {
  std::set<Ends> bad;
  if (finding.kind == CellKind::Edge)
    for (const std::size_t e : finding.float_cells)
      bad.insert(
          ends(float_.vertices[float_.edges[e].tail], float_.vertices[float_.edges[e].head]));
  std::size_t owner = outputs_.size() - 1;
  for (std::size_t k = outputs_.size() - 1; k > 0; --k) {
    if (outputs_[k].stage != Stage::Intersect) continue;
    std::set<Ends> here;
    for (const SegmentD& s : outputs_[changed(k)].work.segments)
      if (const Ends e = ends(s.a, s.b); bad.contains(e)) here.insert(e);
    if (here.size() < bad.size() || bad.empty()) break;
    owner = k;
  }
  return owner;
}

void Attribution::blame_invalid() {
  for (Finding& finding : result_.findings)
    if (is_about_line_work(finding)) blame(finding, owner_of_invalid(finding));
  blame_invalid_cells();
}

/// Where edges cross, cycles and nesting mean nothing; else they are wrong by themselves.
void Attribution::blame_invalid_cells() {
  const auto of_lines = std::find_if(result_.findings.begin(), result_.findings.end(),
                                     [](const Finding& f) { return is_about_line_work(f); });
  const bool is_crossed = of_lines != result_.findings.end();
  for (Finding& finding : result_.findings) {
    if (finding.disagreement != Disagreement::Invalid || finding.cause) continue;
    if (is_crossed)
      finding.cause = of_lines->cause;
    else
      blame(finding, outputs_.size());
  }
}

/// What is left was there in the rounded input already.
void Attribution::take_from_conversion() {
  const WrongCells wrong(conversion_, exact_);
  for (const std::size_t i : open_) {
    Finding& finding = result_.findings[i];
    const Finding* same = wrong.same(finding);
    if (same && same->cause)
      finding.cause = same->cause;
    else
      blame(finding, 0);
  }
  open_.clear();
}

/// What follows from another finding of the same stage has its rule.
void Attribution::explain() {
  for (Finding& finding : result_.findings) {
    Cause& cause = *finding.cause;
    if (!cause.rule.empty()) continue;
    for (const std::size_t number : finding.because) {
      const Cause& earlier = *result_.findings[number - 1].cause;
      if (earlier.stage != cause.stage || earlier.round != cause.round) continue;
      cause = earlier;
      break;
    }
    if (cause.rule.empty()) run_.explain(finding, cause);
  }
}

/// Replaces each stage that owns findings by the exact one, once, and lets the later ones run.
void Attribution::run_without_owners() {
  std::map<std::pair<Stage, std::size_t>, std::vector<Finding*>> by_stage;
  for (Finding& finding : result_.findings)
    by_stage[{finding.cause->stage, finding.cause->round}].push_back(&finding);
  const bool is_large = exact_.edge_count() > kMostEdgesRunAgain;
  for (const auto& [place, findings] : by_stage) {
    if (place.first == Stage::Parse || place.first == Stage::Transform) continue;
    if (is_large && result_.float_valid) continue;
    const std::optional<FloatComplex> replaced = run_.with_exact(place.first, place.second);
    if (!replaced) continue;
    const Crosscheck now = crosscheck(exact_, *replaced, result_.tolerance);
    const WrongCells wrong(now, exact_);
    for (Finding* finding : findings) {
      if (finding->disagreement == Disagreement::Invalid) {
        finding->cause->remade = !now.float_valid;
        if (!is_cut_once_ || now.float_valid) finding->cause->confirmed = now.float_valid;
      } else {
        finding->cause->remade = wrong.has(*finding);
      }
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

void attribute(Crosscheck& result, const ExactComplex& exact_complex,
               const FloatComplex& float_complex, const TracedRun& run,
               const Crosscheck& conversion, std::size_t threads) {
  if (result.agree()) return;
  Attribution(result, exact_complex, float_complex, run, conversion, threads).run();
}

void attribute_conversion(Crosscheck& conversion, const Crosscheck* parsed,
                          const ExactComplex& exact_complex) {
  std::optional<WrongCells> wrong;
  if (parsed) wrong.emplace(*parsed, exact_complex);
  for (Finding& finding : conversion.findings) {
    const bool by_parsing = !wrong || wrong->has(finding);
    finding.cause = by_parsing ? parsing() : transforming();
  }
}

void attribute_foreign(Crosscheck& result, const ExactComplex& exact_complex,
                       const Crosscheck& conversion) {
  const WrongCells converted(conversion, exact_complex);
  for (Finding& finding : result.findings) {
    const bool is_invalid = finding.disagreement == Disagreement::Invalid;
    if (const Finding* same = is_invalid ? nullptr : converted.same(finding); same && same->cause) {
      finding.cause = same->cause;
      continue;
    }
    Cause cause;
    cause.rule = rule_of(finding);
    cause.explanation = "rounding the drawing to doubles does not make it: its maker did";
    if (finding.distance && *finding.distance > 0 && !is_invalid)
      cause.advice = fmt::format("a tolerance or grid below {:.3g} there", *finding.distance);
    finding.cause = cause;
  }
}

}  // namespace plumbline::checking
