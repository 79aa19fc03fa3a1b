#pragma once

#include <optional>
#include <vector>

#include "diagnose/line_graph.hpp"

namespace plumbline::diagnose_steps {

/// What becomes a face of its own where a loose end is joined to what it is near. **Rounded**.
class Closings {
 public:
  /// Keeps a reference to the graph. Cost: linear.
  explicit Closings(const LineGraph& graph);

  /// The area of the lesser one of two faces that a line between the tips makes of one; none where
  /// it makes none.
  std::optional<double> between(VertexId tip, VertexId other) const;
  /// The same for a line from the tip to the nearest point of the edge.
  std::optional<double> to_edge(VertexId tip, EdgeId e) const;

 private:
  std::optional<double> closed(HalfedgeId from, HalfedgeId to, const PointD& end) const;
  HalfedgeId leaving(VertexId tip) const;
  PointD at(VertexId v) const;

  const LineGraph& graph_;
  std::vector<CycleId> cycle_;  ///< per halfedge
  std::vector<double> before_;  ///< per halfedge: twice the area along its cycle up to its origin
  std::vector<std::uint32_t> place_;  ///< per halfedge, in its cycle
  std::vector<double> whole_;         ///< per cycle
};

}  // namespace plumbline::diagnose_steps
