#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {

/// A component that is the hole of the wrong face, or of none.
struct Misplaced {
  enum class Kind {
    FirstBox,  ///< it is in the first face whose box has its box, and not inside of that face
    OnShell    ///< its vertex that was asked lies on the shell of the component around it
  };
  Kind kind = Kind::FirstBox;
  PointD where;
};

/// What is wrong with the faces of a run whose edges are taken as they are.
struct Faults {
  bool is_plane = true;          ///< edges meet in common vertices only
  bool misorders_edges = false;  ///< edges around a vertex are not in the order of their angles
  bool misjudges_areas = false;  ///< a shell is no clockwise ring
  std::vector<Misplaced> misplaced;
};
Faults faults_of(const Trace& trace, std::size_t threads);

}  // namespace plumbline::plasm
