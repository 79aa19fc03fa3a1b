#include <catch2/catch.hpp>

#include "repair/outcome.hpp"
#include "repair/promises.hpp"

using namespace plumbline;
using namespace plumbline::repairs;

TEST_CASE("repairs of small damaged drawings keep what is promised") {
  std::size_t edits = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    INFO("seed " << seed);
    const Verdict verdict = judged(trial(seed));
    INFO(verdict.detail);
    CHECK(verdict.broken.empty());
    edits += verdict.edits;
  }
  CHECK(edits > 400);
}

TEST_CASE("rooms come back where damages are below a quarter of the details") {
  for (std::size_t d = 0; d < kDamages; ++d) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const auto damage = static_cast<Damage>(d);
      INFO(to_text(damage) << ", seed " << seed);
      const Plan drawn = plan(damage, Rational(1, 8), seed);
      RepairOptions options;
      for (auto* each : {&options.weld, &options.grow, &options.trim, &options.sliver}) {
        *each = has_size(damage) ? drawn.size : Rational(0);
      }
      if (has_doors(damage)) options.doors = door_widths();
      const Judgement judgement = judged(drawn, repair(drawn.damaged, options));
      INFO("room at " << judgement.where);
      CHECK(judgement.outcome != Outcome::Harm);
      // Openings that short or damaged walls lead to are no doors yet.
      if (damage == Damage::DoorsByCorners || damage == Damage::All) continue;
      CHECK(judgement.outcome <= Outcome::Right);
    }
  }
}
