#pragma once

#include <memory>

#include "engine/merged_vertices.hpp"
#include "engines/lar/explain/stages.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {

/// A run of the pipeline that `check` can look into.
class ExplainedRun : public Run {
 public:
  ExplainedRun(std::shared_ptr<const Trace> trace, std::size_t threads);

  std::vector<StageOutput> outputs() const override;
  std::string late_stage(const Finding& finding) const override;
  Cause explained(const Finding& finding, Cause cause) const override;
  std::optional<FloatComplex> with_exact(const std::string& stage,
                                         std::size_t round) const override;

 private:
  /// A place where an edge was led away from its line.
  struct Bend {
    PointD point;
    double distance = 0;  ///< from the line
  };

  void explain_merge(const Finding& finding, Cause& cause) const;
  void explain_meeting(const Finding& finding, Cause& cause) const;
  const Graph& before(std::size_t round) const;
  engine_steps::MergedVertices merged_in(std::size_t round) const;
  std::vector<std::pair<SegmentId, Bend>> bends_in(std::size_t round) const;
  const Bend* bend_near(const PointD& p, std::size_t round) const;
  LineWork line_work(const Graph& graph) const;
  /// The exact arrangement of a graph, its vertices rounded.
  Graph arranged(const Graph& graph) const;
  PointD drawn(const PointD& p) const;

  const std::shared_ptr<const Trace> owner_;
  const Trace& trace_;
  const std::size_t threads_;
  std::vector<engine_steps::MergedVertices> merged_;            ///< per round
  std::vector<std::vector<std::pair<SegmentId, Bend>>> bends_;  ///< per round, by segment
  std::vector<std::vector<Bend>> bends_by_x_;                   ///< per round
};

}  // namespace plumbline::lar
