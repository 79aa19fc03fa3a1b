#pragma once

#include <string>
#include <vector>

#include "plumbline/repair.hpp"
#include "repair/plans.hpp"

namespace plumbline::repairs {

/// What became of a plan's rooms (its bounded faces) by a repair, from the best to the worst.
enum class Outcome {
  Exact,   ///< they are there, and no others, with their areas
  Right,   ///< so they are, with areas within the damage: a border moved no further than its size
  Listed,  ///< some are not, each near something refused, or on the list of changed faces
  Unsaid,  ///< some that the damage took are still missing, and nothing is said of them
  Harm     ///< some that were there are gone, or there are new faces, and nothing says so
};
inline constexpr std::size_t kOutcomes = 5;

struct Judgement {
  Outcome outcome = Outcome::Exact;
  std::size_t harmed = 0;  ///< rooms that were there, and are gone, listed or not
  std::string where;       ///< of the first room that is not right
};

/// The rooms of a plan: how to know each of them again.
struct Room {
  Point inside;
  Rational area;
  double perimeter = 0;
};
std::vector<Room> rooms_of(const ExactComplex& complex);

/// Holds a repair of the damaged plan against the right one, by faces alone.
Judgement judged(const Plan& plan, const Repair& repair);

}  // namespace plumbline::repairs
