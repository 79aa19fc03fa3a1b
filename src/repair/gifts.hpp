#pragma once

#include <vector>

#include "repair/work.hpp"

namespace plumbline::repair_steps {

/// What would make a sliver part of its neighbour.
struct Gift {
  FaceId face, neighbour;
  Rational area;
  Rational squared_size;      ///< how wide the sliver is
  std::vector<EdgeId> edges;  ///< that would go
};

/// What `give_slivers` would do, the smallest area first.
std::vector<Gift> gifts(const Work& work, const Arranged& arranged, const Rational& distance);

}  // namespace plumbline::repair_steps
