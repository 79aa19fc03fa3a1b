// A repair from above, and each promise that it makes.

#include <iterator>
#include <utility>

#include "edits/steps.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline {

std::vector<Breach> verify(const SegmentSet& input, const ExactComplex& before,
                           const Repair& repair, const ExactComplex& after) {
  using namespace edits;
  std::vector<Breach> result;
  const auto add = [&](std::vector<Breach> breaches) {
    std::ranges::move(breaches, std::back_inserter(result));
  };
  // What follows would find nothing of what it looks for where one of these fails.
  add(check_form(input, repair));
  if (result.empty()) add(check_rules(input, repair));
  if (result.empty()) {
    const Replay states = replay(input, repair);
    add(states.breaches);
    if (result.empty()) {
      add(check_surroundings(input, repair, states));
      add(check_movement(input, repair, states));
      add(check_meetings(input, repair, after));
      add(check_faces(before, repair, after));
    }
  }
  if (result.size() > kMaxBreaches) result.resize(kMaxBreaches);
  return result;
}

std::vector<Breach> verify(const SegmentSet& input, const Repair& repair) {
  return verify(input, arrange(input), repair, arrange(repair.output));
}

}  // namespace plumbline
