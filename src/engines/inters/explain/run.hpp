#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/merged_vertices.hpp"
#include "engines/inters/explain/dropped_edges.hpp"
#include "engines/inters/explain/lattice.hpp"
#include "engines/inters/explain/meetings.hpp"
#include "engines/inters/explain/stages.hpp"
#include "engines/inters/explain/walk.hpp"
#include "engines/inters/explain/work.hpp"
#include "plumbline/engine.hpp"

namespace plumbline::inters {

/// A run of the published pipeline that `check` can look into.
class ExplainedRun : public Run {
 public:
  ExplainedRun(std::shared_ptr<const Trace> trace, Result result, std::size_t threads);

  /// The result, or as much of it as there is, as a complex.
  FloatComplex complex() const;
  /// Whether there is a result; if not, the complex is the vertices and edges so far.
  bool has_faces() const { return has_result(trace_, result_); }
  /// Why there is no result, or only a part of it: findings about the complex, with their causes.
  std::vector<Explained> failures() const;

  std::vector<StageOutput> outputs() const override;
  ExactComplex continued(const StageOutput& output, std::size_t threads) const override;
  std::string late_stage(const Finding& finding) const override;
  Cause explained(const Finding& finding, Cause cause) const override;
  std::optional<FloatComplex> with_exact(const std::string& stage,
                                         std::size_t round) const override;
  /// What hangs loose because an intersection was missed, and is left out for that, belongs to the
  /// intersection.
  std::optional<std::string> suspect(const Cause& cause) const override;
  /// Also where the conversion to doubles left an end beside a segment, which the pipeline does not
  /// heal.
  Cause refined(const Finding& finding, Cause cause) const override;

 private:
  void explain_quantisation(const Finding& finding, Cause& cause) const;
  void explain_meeting(const Finding& finding, Cause& cause) const;
  void explain_merge(const Finding& finding, Cause& cause) const;
  void explain_filter(const Finding& finding, Cause& cause) const;
  void explain_walk(Cause& cause) const;
  void explain_conversion(const Finding& finding, Cause& cause) const;
  void explain_outer_face(const Finding& finding, Cause& cause) const;
  void explain_nesting(const Finding& finding, Cause& cause) const;
  bool is_small() const;
  Explained failure(const Failure& failure) const;

  const std::shared_ptr<const Trace> owner_;
  const Trace& trace_;
  const Result result_;
  const std::size_t threads_;
  const EdgeSources raw_sources_;
  const EdgeSources lar_sources_;
  const engine_steps::MergedVertices merged_;
  const Meetings meetings_;
  const DroppedEdges dropped_;
  const Walk walk_;
  const Lattice lattice_;
};

}  // namespace plumbline::inters
