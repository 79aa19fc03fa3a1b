#include <fmt/format.h>

#include <algorithm>

#include "cli/repair_rules.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {

void tell_rules(const SegmentSet& input, const Repair& repaired, Report& report) {
  const Tolerances& used = repaired.tolerances;
  const Rational tolerance = std::max({used.weld, used.grow, used.trim, used.snap});
  if (sgn(tolerance) == 0) {
    report.print("no rule to compare: nothing moves, grows or goes at a tolerance of 0\n");
    return;
  }
  std::vector<Summary> rules;
  report.print("at a tolerance of {}, with vertices that are not where one was drawn:\n",
               tolerance_text(tolerance));
  report.print("{:<12} {:>8} {:>8} {:>8} {:>14} {:>8} {:>8} {:>10}\n", "rule", "vertices", "edges",
               "faces", "area", "skewed", "moved", "by up to");
  for (const RuleOutcome& rule : compare_rules(input, repaired, nearest_double(tolerance))) {
    report.print("{:<12} {:>8} {:>8} {:>8} {:>14.8g} {:>8} {:>8} {:>10.3g}\n", rule.rule,
                 rule.vertices, rule.edges, rule.faces, rule.area, rule.skewed, rule.moved,
                 rule.furthest);
    rules.emplace_back();
    rules.back().set("rule", rule.rule);
    rules.back().set("vertices", rule.vertices);
    rules.back().set("edges", rule.edges);
    rules.back().set("faces", rule.faces);
    rules.back().set("area", rule.area);
    rules.back().set("skewed", rule.skewed);
    rules.back().set("moved", rule.moved);
    rules.back().set("furthest", rule.furthest);
  }
  report.set("rules", rules);
}

}  // namespace plumbline::cli
