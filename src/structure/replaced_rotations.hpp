#pragma once

#include <map>
#include <set>
#include <vector>

#include "structure/placement.hpp"

namespace plumbline {

/// Which rotations of placements were replaced.
class ReplacedRotations {
 public:
  void add(const Placement& placement, Rotations& rotations);
  /// In the order of first use.
  std::vector<Replacement> ledger(double bound) const;

 private:
  struct Angle {
    Rational degrees;
    Source first;
    std::set<const Turn*> turns;
  };

  std::vector<Angle> angles_;
  std::map<Rational, std::size_t> place_;  ///< in angles_
};

}  // namespace plumbline
