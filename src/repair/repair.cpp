#include "plumbline/repair.hpp"

#include "plumbline/error.hpp"
#include "repair/steps.hpp"

namespace plumbline {
namespace {

using namespace repair_steps;

Tolerances chosen(const RepairOptions& options) {
  Tolerances result{options.weld.value_or(0),
                    options.grow.value_or(0),
                    options.trim.value_or(0),
                    options.sliver.value_or(0),
                    options.snap,
                    options.simplify,
                    options.doors};
  return result;
}

/// More often than any drawing needs.
constexpr std::size_t kMostRounds = 100;

/// Until nothing moves any more.
void weld_and_merge(Work& work, Arranged& now, const Rational& distance) {
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    const std::size_t edits = work.edits().size();
    weld(work, now, distance);
    if (work.edits().size() == edits) return;
    now = arranged(work);
    merge(work, now);
    now = arranged(work);
  }
}

/// All steps, one after the other.
void repair_once(Work& work, const Tolerances& tolerances, const RepairOptions& options) {
  const std::size_t first_edit = work.edits().size();
  Arranged now = arranged(work);
  auto arrange_anew = [&, edits = first_edit]() mutable {
    if (work.edits().size() == edits) return;
    edits = work.edits().size();
    now = arranged(work);
  };
  merge(work, now);
  arrange_anew();
  if (sgn(tolerances.weld) > 0) weld_and_merge(work, now, tolerances.weld);
  if (sgn(tolerances.grow) > 0) grow(work, now, tolerances.grow);
  arrange_anew();
  if (sgn(tolerances.trim) > 0) trim(work, now, tolerances.trim);
  arrange_anew();
  if (sgn(tolerances.sliver) > 0) {
    give_slivers(work, now, tolerances.sliver);
    arrange_anew();
  }
  if (tolerances.doors) close_doors(work, *tolerances.doors, options.walls);
  arrange_anew();
  dissolve(work, now, first_edit);
}

}  // namespace

Repair repair(const SegmentSet& input, const RepairOptions& options) {
  Repair result;
  result.tolerances = chosen(options);
  Work work(input, result.anchored);
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    const std::size_t edits = work.edits().size();
    repair_once(work, result.tolerances, options);
    if (work.edits().size() == edits) break;
  }
  work.write(result);
  return result;
}

}  // namespace plumbline
