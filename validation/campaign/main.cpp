// Random inputs on which everything that is expected of an arrangement is checked. Prints the
// summary as markdown; exit code 1 if a case failed, 2 for a wrong usage.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "campaign/campaign.hpp"

using namespace plumbline;

int main(int argc, char** argv) {
  CLI::App app("plumbline_campaign: exact arrangements of random inputs, held against all we know");
  campaign::Plan plan;
  campaign::Amount amount;
  double minutes = std::numeric_limits<double>::infinity();
  std::string commit = "unknown";
  amount.cases = 100'000;
  app.add_option("--cases", amount.cases, "how many")->check(CLI::PositiveNumber);
  app.add_option("--first", amount.first, "number of the first case");
  app.add_option("--minutes", minutes, "how long at most")->check(CLI::PositiveNumber);
  app.add_option("--seed", plan.seed, "of the whole campaign");
  app.add_option("--family", plan.families, "only these; all if none is given")
      ->check(CLI::IsMember(inputs::families()));
  app.add_flag("--claims", plan.claims, "what check claims of float LAR's answers, nothing else");
  app.add_option("--commit", commit, "what the summary calls the tested commit");
  CLI11_PARSE(app, argc, argv);
  if (plan.families.empty()) plan.families = inputs::families();
  amount.seconds = 60 * minutes;
  const campaign::Summary summary = campaign::run(plan, amount);
  fmt::print("{}", campaign::table(plan, amount, summary, commit));
  return summary.failures.empty() ? 0 : 1;
}
