#include "structure/replaced_rotations.hpp"

#include <string>

namespace plumbline {

void ReplacedRotations::add(const Placement& placement, Rotations& rotations) {
  const Turn* turn = placement.last_turn();
  for (const Rational& degrees : placement.angles()) {
    if (sgn(rotations(degrees).bound) == 0) continue;
    const auto [place, is_new] = place_.try_emplace(degrees, angles_.size());
    if (is_new) angles_.push_back({degrees, turn->source, {}});
    angles_[place->second].turns.insert(turn);
  }
}

std::vector<Replacement> ReplacedRotations::ledger(double bound) const {
  std::vector<Replacement> result;
  for (const Angle& angle : angles_) {
    std::string what = "rotation by " + exact_text(angle.degrees) + " degrees";
    const std::size_t count = angle.turns.size();
    if (count > 1) what += " (" + std::to_string(count) + " of them)";
    result.push_back({angle.first, what, shortest_text(bound) + " rad"});
  }
  return result;
}

}  // namespace plumbline
