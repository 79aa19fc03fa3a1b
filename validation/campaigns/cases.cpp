#include "campaigns/cases.hpp"

#include "campaigns/dice.hpp"

namespace campaign {
namespace {

constexpr std::size_t kFullPlaces = 1024;
constexpr std::size_t kUsualSize = 256;

/// All relations alike, but threads seldom: to start and stop them takes longer than all the rest.
Relation any_relation(Dice& dice) {
  constexpr std::size_t kThreads = 64;
  static_assert(kRelations.back() == Relation::Threads);
  if (dice.one_in(kThreads)) return Relation::Threads;
  return kRelations[static_cast<std::size_t>(dice.pick(kRelations.size() - 1))];
}

/// A family that has full places or one that has none, if the plan has such.
std::size_t any_family(const Plan& plan, bool is_full, Dice& dice) {
  std::vector<std::size_t> fitting;
  for (std::size_t f = 0; f < plan.families.size(); ++f) {
    if (random_segments::is_full_place(plan.families[f]) == is_full) fitting.push_back(f);
  }
  if (fitting.empty()) return static_cast<std::size_t>(dice.pick(plan.families.size()));
  return fitting[static_cast<std::size_t>(dice.pick(fitting.size()))];
}

}  // namespace

Case case_of(const Plan& plan, std::uint64_t number) {
  Dice dice(Dice(plan.seed).roll() + number);
  Case one{};
  one.family = any_family(plan, dice.one_in(kFullPlaces), dice);
  one.seed = static_cast<unsigned>(dice.roll());
  one.extent =
      dice.one_in(kUsualSize) ? random_segments::Extent::Usual : random_segments::Extent::Small;
  one.relation = any_relation(dice);
  one.dice = dice.roll();
  return one;
}

plumbline::SegmentSet input_of(const Plan& plan, const Case& one) {
  return random_segments::make(plan.families[one.family], one.seed, one.extent);
}

}  // namespace campaign
