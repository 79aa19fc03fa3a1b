#pragma once

#include <span>
#include <vector>

#include "engines/inters/explain/work.hpp"

namespace plumbline::inters {

/// The edges that the published pipeline leaves out of a result.
class DroppedEdges {
 public:
  enum class Why {
    NoCycle,       ///< a bridge or a dangling edge
    FewerEdges,    ///< of a component smaller than the one that is kept
    LargerExtent,  ///< of a component with fewer edges, but a larger box
  };

  DroppedEdges(const Trace& trace, Result result, const EdgeSources& sources);

  /// Why the nearest dropped edge that is part of one of the segments is missing; none if no edge
  /// of them is.
  std::optional<Why> nearest_to(const PointD& p, std::span<const SegmentId> segments) const;

 private:
  struct DroppedEdge {
    SegmentD segment;
    Why why;
  };
  void add(const Trace& trace, const lar::VertexPair& edge, Why why, const EdgeSources& sources);

  std::vector<DroppedEdge> edges_;
  std::vector<std::pair<SegmentId, std::size_t>> by_segment_;
};

}  // namespace plumbline::inters
