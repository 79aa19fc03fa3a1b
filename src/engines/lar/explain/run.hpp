#pragma once

#include "engine/merged_vertices.hpp"
#include "engine/stages.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::checking {

/// A run of the repaired pipeline.
class RepairedRun : public TracedRun {
 public:
  /// Keeps references.
  RepairedRun(const SegmentSet& input, const lar::Trace& trace, std::size_t threads);

  std::vector<StageOutput> outputs() const override;
  Stage late_stage(const Finding& finding) const override;
  void explain(const Finding& finding, Cause& cause) const override;
  std::optional<FloatComplex> with_exact(Stage stage, std::size_t round) const override;

 private:
  /// A place where an edge was led away from its line.
  struct Bend {
    PointD point;
    double distance = 0;  ///< from the line
  };

  void explain_merge(const Finding& finding, Cause& cause) const;
  void explain_meeting(const Finding& finding, Cause& cause) const;
  const lar::Graph& before(std::size_t round) const;
  MergedVertices merged_in(std::size_t round) const;
  std::vector<std::pair<SegmentId, Bend>> bends_in(std::size_t round) const;
  const Bend* bend_near(const PointD& p, std::size_t round) const;
  LineWork line_work(const lar::Graph& graph) const;
  /// The exact arrangement of a graph, its vertices rounded.
  lar::Graph arranged(const lar::Graph& graph) const;
  PointD drawn(const PointD& p) const;

  const SegmentSet& input_;
  const lar::Trace& trace_;
  const std::size_t threads_;
  std::vector<MergedVertices> merged_;                          ///< per round
  std::vector<std::vector<std::pair<SegmentId, Bend>>> bends_;  ///< per round, by segment
  std::vector<std::vector<Bend>> bends_by_x_;                   ///< per round
};

}  // namespace plumbline::checking
