// The summary of a campaign as markdown.

#include <fmt/format.h>

#include <algorithm>

#include "campaign/campaign.hpp"

namespace plumbline::campaign {
namespace {

FamilyTotals sum(const std::vector<FamilyTotals>& families) {
  FamilyTotals all;
  for (const FamilyTotals& f : families) {
    all.cases += f.cases;
    all.segments += f.segments;
    all.most_segments = std::max(all.most_segments, f.most_segments);
    all.failures += f.failures;
    all.seconds += f.seconds;
  }
  return all;
}

std::string row(const std::string& name, const FamilyTotals& f) {
  const auto cases = static_cast<double>(std::max<std::uint64_t>(f.cases, 1));
  return fmt::format("| {} | {} | {} | {:.1f} | {} | {} | {:.0f} | {:.3f} |\n", name, f.cases,
                     f.segments, static_cast<double>(f.segments) / cases, f.most_segments,
                     f.failures, f.seconds, 1000 * f.seconds / cases);
}

}  // namespace

std::string table(const Plan& plan, const Amount& amount, const Summary& summary,
                  const std::string& commit) {
  const FamilyTotals all = sum(summary.families);
  std::string text = fmt::format(
      "{} cases of {} families ({} to {} of seed {}) at commit {}: {} failures, {:.0f} s on one "
      "process.\n",
      all.cases, plan.families.size(), amount.first, amount.first + amount.cases - 1, plan.seed,
      commit, all.failures, summary.seconds);
  if (all.cases < amount.cases) {
    text += fmt::format("\n**Ended early**: {} cases were asked for; `--first {}` goes on.\n",
                        amount.cases, amount.first + all.cases);
  }
  if (summary.slow > 0) {
    text += fmt::format("\n{} cases took too long or crashed in a batch and passed alone.\n",
                        summary.slow);
  }
  text +=
      "\n| family | cases | segments | mean | most | failures | s | ms per case |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (std::size_t f = 0; f < plan.families.size(); ++f) {
    text += row(plan.families[f], summary.families[f]);
  }
  text += row("**all**", all);
  text += "\n| relation | cases |\n| --- | ---: |\n";
  for (const Relation relation : kRelations) {
    text += fmt::format("| {} | {} |\n", to_text(relation),
                        summary.relations[static_cast<std::size_t>(relation)]);
  }
  for (const Failure& failure : summary.failures) {
    const Case& one = failure.failed;
    text +=
        fmt::format("\n{}: family \"{}\", seed {}, relation \"{}\"\n\n```\n{}```\n", failure.what,
                    plan.families[one.family], one.seed, to_text(one.relation), failure.rows);
  }
  return text;
}

}  // namespace plumbline::campaign
