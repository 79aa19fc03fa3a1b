#include "campaign/cases.hpp"

#include "campaign/dice.hpp"

namespace plumbline::campaign {
namespace {

constexpr std::size_t kFullPlaces = 2048;
constexpr std::size_t kUsualSize = 256;
constexpr std::size_t kDear = 4;

/// All relations alike but the two that cost more than all the rest of a case; no claims.
Relation any_relation(Dice& dice) {
  constexpr std::size_t kSeldom = 64;
  if (dice.one_in(kSeldom)) return Relation::Threads;
  if (dice.one_in(kSeldom / 2)) return Relation::Noded;
  constexpr std::size_t kOthers = kRelations.size() - 3;
  static_assert(kRelations[kOthers] == Relation::Noded);
  return kRelations[static_cast<std::size_t>(dice.pick(kOthers))];
}

/// A family of that cost, if the plan has one.
std::size_t any_family(const Plan& plan, inputs::Cost cost, Dice& dice) {
  std::vector<std::size_t> fitting;
  for (std::size_t f = 0; f < plan.families.size(); ++f) {
    if (inputs::cost(plan.families[f]) == cost) fitting.push_back(f);
  }
  if (fitting.empty()) return static_cast<std::size_t>(dice.pick(plan.families.size()));
  return fitting[static_cast<std::size_t>(dice.pick(fitting.size()))];
}

inputs::Cost any_cost(Dice& dice) {
  if (dice.one_in(kFullPlaces)) return inputs::Cost::FullPlace;
  return dice.one_in(kDear) ? inputs::Cost::Dear : inputs::Cost::Cheap;
}

}  // namespace

Case case_of(const Plan& plan, std::uint64_t number) {
  Dice dice(Dice(plan.seed).roll() + number);
  Case one{};
  one.family = any_family(plan, any_cost(dice), dice);
  one.seed = static_cast<unsigned>(dice.roll());
  one.extent = dice.one_in(kUsualSize) ? inputs::Extent::Usual : inputs::Extent::Small;
  one.relation = any_relation(dice);
  if (plan.claims) one.relation = Relation::Claims;
  one.dice = dice.roll();
  return one;
}

SegmentSet input_of(const Plan& plan, const Case& one) {
  return inputs::of_family(plan.families[one.family], one.seed, one.extent);
}

}  // namespace plumbline::campaign
