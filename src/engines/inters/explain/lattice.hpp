#pragma once

#include <map>
#include <span>
#include <vector>

#include "engines/inters/explain/work.hpp"

namespace plumbline::inters {

/// What is wrong in the published containment lattice, and which cycles it concerns.
class Lattice {
 public:
  enum class Fault {
    Alternates,  ///< nothing: solid and void alternate by design
    OnBoundary,  ///< a vertex on the other cycle spoils the levels
    OneVertex,   ///< the one vertex looked at is misplaced, another one of the cycle is not
    Crossings,   ///< all vertices of the cycle are misplaced: half crossings do not count
    Unrounded,   ///< the polygon was rounded, the vertex on it was not
  };

  /// Looks at nothing but CellsFromCycles. Cost: as the lattice.
  Lattice(const Trace& trace, Result result, const EdgeSources& sources);

  /// The first fault that concerns a cycle with one of the segments.
  Fault fault_at(std::span<const SegmentId> segments) const;

 private:
  std::map<std::size_t, Fault> faults_;  ///< by component
  std::multimap<SegmentId, std::size_t> components_of_;
};

/// The corners of a component that is a simple cycle, in the order of the walk.
std::vector<VertexId> ring(std::span<const lar::VertexPair> cycle);

}  // namespace plumbline::inters
