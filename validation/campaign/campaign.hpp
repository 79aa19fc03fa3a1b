#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/cases.hpp"

namespace plumbline::campaign {

struct FamilyTotals {
  std::uint64_t cases = 0;
  std::uint64_t segments = 0;
  std::uint64_t most_segments = 0;
  std::uint64_t failures = 0;
  double seconds = 0;
};

struct Failure {
  Case failed;
  std::string what;
  std::string rows;  ///< of the input, made small
};

struct Summary {
  std::vector<FamilyTotals> families;  ///< as in the plan
  std::array<std::uint64_t, kRelations.size()> relations{};
  std::vector<Failure> failures;
  std::uint64_t slow = 0;  ///< cases that looked like a hang and passed when run alone
  double seconds = 0;
};

/// How much to do: as many cases from number `first`, and as long, as is allowed.
struct Amount {
  std::uint64_t first = 0;
  std::uint64_t cases = 0;
  double seconds = 0;
};

/// More failures end a campaign.
inline constexpr std::size_t kMostFailures = 50;

/// Runs the cases in child processes, one at a time, a batch each; a case that crashes or hangs
/// there is found, run again alone, and minimised like any that fails. Ends early, with what is
/// done by then, on SIGINT and SIGTERM. Prints failures as they are found, and progress to a
/// terminal. Requires: the process has one thread.
Summary run(const Plan& plan, const Amount& amount);

/// The summary as markdown.
std::string table(const Plan& plan, const Amount& amount, const Summary& summary,
                  const std::string& commit);

}  // namespace plumbline::campaign
