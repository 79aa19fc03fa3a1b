#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/line_work.hpp"
#include "plumbline/compare.hpp"

namespace plumbline::checking {

/// What a stage of a run left behind. Continued exactly from there, it is `arrange(work)`.
struct StageOutput {
  Stage stage;
  std::size_t round = 0;  ///< from 1; 0 outside of rounds
  bool changed = true;    ///< if not, `work` is left out: it is that of the output before
  LineWork work;
  /// The later stages never cut again: where pieces meet elsewhere than in common ends, the exact
  /// continuation is the cells of the graph as it is.
  bool is_cut = false;
};

/// A run of a float pipeline, as attribution looks at it.
class TracedRun {
 public:
  TracedRun() = default;
  TracedRun(const TracedRun&) = delete;
  TracedRun& operator=(const TracedRun&) = delete;
  virtual ~TracedRun() = default;

  /// The outputs of the stages that have line work, in their order. The first is that of Transform:
  /// the rounded input. Coordinates are the drawing's.
  virtual std::vector<StageOutput> outputs() const = 0;
  /// The stage after the last of `outputs` that made a finding: edge order to nesting.
  virtual Stage late_stage(const Finding& finding) const = 0;
  /// Fills in rule, explanation and advice of a cause whose stage and round are known.
  virtual void explain(const Finding& finding, Cause& cause) const = 0;
  /// The result with this one stage (of this round) replaced by its exact counterpart, whose output
  /// is rounded for the stages after it; none where that can't be done in doubles.
  virtual std::optional<FloatComplex> with_exact(Stage stage, std::size_t round) const = 0;
};

}  // namespace plumbline::checking
