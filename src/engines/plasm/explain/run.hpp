#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/merged_vertices.hpp"
#include "engines/plasm/explain/cuts.hpp"
#include "engines/plasm/explain/faults.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {

/// A run that `check` can look into.
class ExplainedRun : public Run {
 public:
  ExplainedRun(std::shared_ptr<const Trace> trace, std::size_t threads);

  std::vector<StageOutput> outputs() const override;
  ExactComplex continued(const StageOutput& output, std::size_t threads) const override;
  std::string late_stage(const Finding& finding) const override;
  Cause explained(const Finding& finding, Cause cause) const override;
  std::optional<FloatComplex> with_exact(const std::string& stage,
                                         std::size_t round) const override;
  /// What hangs loose because a meeting was missed, and is left out for that, belongs to the cuts.
  std::optional<std::string> suspect(const Cause& cause) const override;

 private:
  void explain_cut(const Finding& finding, Cause& cause) const;
  void explain_merge(const Finding& finding, Cause& cause) const;
  void explain_filter(const Finding& finding, Cause& cause) const;
  void explain_nesting(const Finding& finding, Cause& cause) const;

  const std::shared_ptr<const Trace> owner_;
  const Trace& trace_;
  const std::size_t threads_;
  const OddCuts odd_cuts_;
  engine_steps::MergedVertices merged_;
  std::vector<PointD> contested_;  ///< what merged vertices became whose members others had, too
  const Faults faults_;
};

/// Why there is no result, as a finding about the whole complex; none where there is one.
std::vector<Explained> failures(const Trace& trace);

}  // namespace plumbline::plasm
