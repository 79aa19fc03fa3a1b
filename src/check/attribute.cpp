// From findings to the stages that made them.

#include "check/attribute.hpp"

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

bool is_of_conversion(const Cause& cause) {
  return cause.stage == kParse || cause.stage == kTransform;
}

bool is_same_stage(const Cause& cause, const Cause& other) {
  return cause.stage == other.stage && cause.round == other.round;
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
        grown_(findings_.size()),
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
    join_reasons();
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
  /// the stage after it, or to a later one that made more of it.
  void close_absent(std::size_t k);
  Cause owned_by(const Finding& finding, std::size_t owner) const;
  void note_growth(std::size_t i, std::size_t k, std::size_t extent);
  bool goes_on(const Finding& moved, const Finding& before, const ExactComplex& complex) const;
  /// The cause of a finding that began with this one.
  Cause completed(std::size_t i, Cause begun) const;
  void blame_invalid();
  void blame_invalid_cells();
  std::size_t owner_of_invalid(const Finding& finding) const;
  bool are_about_faces(const std::vector<std::size_t>& findings) const {
    return std::any_of(findings.begin(), findings.end(), [&](std::size_t i) {
      return findings_[i].kind == CellKind::Face || findings_[i].kind == CellKind::Hole;
    });
  }
  bool take_correspondence(const std::vector<std::size_t>& findings) const {
    return std::any_of(findings.begin(), findings.end(), [&](std::size_t i) {
      return compare_steps::takes_correspondence(findings_[i]);
    });
  }
  /// The last output that changed something, up to k.
  std::size_t changed(std::size_t k) const;
  void take_from_conversion();
  void explain();
  void take_rule(std::size_t i, Cause& cause);
  void join_reasons();
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
  /// What later stages made more of a finding, from the last one on; and how much it was before.
  struct Growth {
    std::vector<std::size_t> owners;
    std::optional<std::size_t> extent = {};
  };
  std::vector<Growth> grown_;                 ///< per finding
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
  std::optional<ExactComplex> complex;
  std::optional<Comparison> continued;
  if (const std::size_t with_work = changed(k); with_work > 0) {
    complex = run_.continued(outputs_[with_work], threads_);
    continued = compare_steps::compare_cells(exact_, *complex, comparison_.tolerance,
                                             are_about_faces(open_));
  }
  const Comparison& there = continued ? *continued : converted_.comparison;
  const compare_steps::WrongCells wrong(there, exact_);
  std::erase_if(open_, [&](std::size_t i) {
    const Finding& finding = findings_[i];
    if (finding.invariant) {
      if (breaks_too(there, finding)) return false;
    } else if (wrong.has(finding)) {
      const bool moved_on = goes_on(finding, there.findings[*wrong.same(finding)],
                                    complex ? *complex : converted_.complex);
      note_growth(i, k, wrong.extent(finding) - (moved_on ? 1 : 0));
      return false;
    }
    Cause begun = owned_by(finding, k + 1);
    begun.confirmed = true;
    causes_[i] = completed(i, std::move(begun));
    return true;
  });
}

/// Whether a moved vertex, which the complex of an earlier stage has moved, too, went on from
/// there.
bool Attribution::goes_on(const Finding& moved, const Finding& before,
                          const ExactComplex& complex) const {
  if (moved.disagreement != Disagreement::Moved || before.disagreement != Disagreement::Moved) {
    return false;
  }
  const Point there = complex.vertices[before.float_cells.front()];
  const Rational tolerance = rational_from(comparison_.tolerance);
  return squared_distance(there, exact(float_.vertices[moved.float_cells.front()])) >
         tolerance * tolerance;
}

/// If there is less of the finding at stage k than later on, the stage after it made some of it.
void Attribution::note_growth(std::size_t i, std::size_t k, std::size_t extent) {
  Growth& growth = grown_[i];
  if (extent >= growth.extent.value_or(compare_steps::WrongCells::whole(findings_[i]))) return;
  growth.extent = extent;
  growth.owners.push_back(k + 1);
}

Cause Attribution::completed(std::size_t i, Cause begun) const {
  const std::vector<std::size_t>& owners = grown_[i].owners;
  if (owners.empty()) return begun;
  Cause cause = owned_by(findings_[i], owners.front());
  cause.confirmed = begun.confirmed;
  cause.with.push_back(std::move(begun));
  for (std::size_t j = owners.size(); j-- > 1;) {
    cause.with.push_back(owned_by(findings_[i], owners[j]));
    cause.with.back().confirmed = cause.confirmed;
  }
  return cause;
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
    Cause begun = same ? converted_.causes[*same] : owned_by(findings_[i], 0);
    std::vector<Cause> earlier = std::move(begun.with);
    begun.with.clear();
    Cause& cause = causes_[i].emplace(completed(i, std::move(begun)));
    cause.with.insert(cause.with.begin(), earlier.begin(), earlier.end());
  }
  open_.clear();
}

void Attribution::explain() {
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    take_rule(i, *causes_[i]);
    for (Cause& other : causes_[i]->with) take_rule(i, other);
  }
}

/// A finding that follows from an earlier one of the same stage has the earlier one's rule.
void Attribution::take_rule(std::size_t i, Cause& cause) {
  if (!cause.rule.empty()) return;
  for (const std::size_t number : findings_[i].because) {
    const Cause& earlier = *causes_[number - 1];
    if (!is_same_stage(earlier, cause)) continue;
    cause.rule = earlier.rule;
    cause.explanation = earlier.explanation;
    cause.advice = earlier.advice;
    cause.distance = earlier.distance;
    return;
  }
  cause = run_.explained(findings_[i], std::move(cause));
}

/// What a finding follows from takes its causes, too. Rounding is the least of them: the cause is a
/// stage of the engine, if one has a part in it.
void Attribution::join_reasons() {
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    Cause& cause = *causes_[i];
    const auto join = [&](const Cause& other) {
      const auto is_same = [&](const Cause& known) { return is_same_stage(known, other); };
      if (is_same(cause) || std::any_of(cause.with.begin(), cause.with.end(), is_same)) return;
      cause.with.push_back(other);
      cause.with.back().with.clear();
    };
    for (const std::size_t number : findings_[i].because) {
      const Cause& earlier = *causes_[number - 1];
      for (const Cause& other : earlier.with) join(other);
      join(earlier);
    }
    const auto of_engine = std::find_if(cause.with.begin(), cause.with.end(),
                                        [](const Cause& c) { return !is_of_conversion(c); });
    if (!is_of_conversion(cause) || of_engine == cause.with.end()) continue;
    std::vector<Cause> others = std::move(cause.with);
    cause.with.clear();
    std::swap(cause, others[static_cast<std::size_t>(of_engine - others.begin())]);
    cause.with = std::move(others);
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

}  // namespace

std::vector<Cause> attribute(const Comparison& comparison, const ExactComplex& exact_complex,
                             const FloatComplex& float_complex, const Run& run,
                             const Converted& converted, std::size_t threads) {
  if (comparison.agree()) return {};
  return Attribution(comparison, exact_complex, float_complex, run, converted, threads).causes();
}

}  // namespace plumbline::check_steps
