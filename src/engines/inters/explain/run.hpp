#pragma once

#include <optional>
#include <vector>

#include "engine/merged_vertices.hpp"
#include "engine/stages.hpp"
#include "engines/inters/explain/dropped_edges.hpp"
#include "engines/inters/explain/lattice.hpp"
#include "engines/inters/explain/meetings.hpp"
#include "engines/inters/explain/walk.hpp"
#include "engines/inters/explain/work.hpp"

namespace plumbline::checking {

/// A run of the published pipeline.
class PublishedRun : public TracedRun {
 public:
  /// Keeps a reference.
  PublishedRun(const lar::published::Trace& trace, PublishedResult result, std::size_t threads);

  /// The result, or as much of it as there is, as a complex.
  FloatComplex complex() const;
  /// Whether there is a result; if not, the complex is the vertices and edges so far.
  bool has_faces() const { return has_result(trace_, result_); }
  std::vector<StageOutput> outputs() const override;
  Stage late_stage(const Finding& finding) const override;
  void explain(const Finding& finding, Cause& cause) const override;
  std::optional<FloatComplex> with_exact(Stage stage, std::size_t round) const override;

  /// Why there is no result, or only a part of it: findings about the complex, with their causes.
  std::vector<Finding> failures() const;
  /// Names the rule more closely, where another finding of the same cause gave it its name, and
  /// where the conversion to doubles left an end beside a segment, which the pipeline does not
  /// heal.
  void refine(Finding& finding) const;

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
  Finding failure(const lar::published::Failure& failure) const;

  const lar::published::Trace& trace_;
  const PublishedResult result_;
  const std::size_t threads_;
  const EdgeSources raw_sources_;
  const EdgeSources lar_sources_;
  const MergedVertices merged_;
  const PublishedMeetings meetings_;
  const DroppedEdges dropped_;
  const PublishedWalk walk_;
  const PublishedLattice lattice_;
};

/// What hangs loose because an intersection was missed, and is left out for that, belongs to the
/// intersection: with that alone replaced by the exact one it is not left out.
void blame_missed_junctions(Crosscheck& result, const ExactComplex& exact_complex,
                            const PublishedRun& run);

}  // namespace plumbline::checking
