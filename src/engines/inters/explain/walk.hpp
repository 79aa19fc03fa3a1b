#pragma once

#include "engines/inters/explain/work.hpp"

namespace plumbline::inters {

/// What may be wrong with the published face walk and what follows it.
struct Walk {
  bool is_plane = true;           ///< the edges that it walks meet in common vertices only
  bool never_ends = false;        ///< it repeats itself
  bool aborted = false;           ///< it stopped and kept the faces found so far
  bool breaks_euler = false;      ///< V - E + F is not that of a plane graph
  bool depends_on_order = false;  ///< other numbers of the vertices give other faces
  /// In single precision the largest face is no larger than another one.
  bool misjudges_areas = false;
  bool misorders_edges = false;  ///< edges around a vertex are not in the order of their angles

  bool is_faulty() const { return never_ends || aborted || breaks_euler || depends_on_order; }
};

/// The walk over `work`, the result's edges.
Walk walk_of(const Trace& trace, Result result, const LineWork& work, std::size_t threads);

}  // namespace plumbline::inters
