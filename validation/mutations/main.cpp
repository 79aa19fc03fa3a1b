// The mutation test in its long form: right results of random drawings and of files, each broken in
// every way; and right results, of six times as many drawings, that must raise no finding. Prints a
// Markdown table. Exit code 1 if something is missed. Usage: plumbline_mutations COUNT [FIRST-SEED
// [FILE...]]

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "inputs/families.hpp"
#include "mutations/mutations.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"

using namespace plumbline;

namespace {

/// Larger results are left out: each is broken in all ways.
constexpr std::size_t kMostVertices = 150;
constexpr std::size_t kMostShown = 10;
/// So many times as many drawings are only left whole.
constexpr unsigned long kUnbroken = 6;

struct Tally {
  std::size_t tried = 0, missed = 0;
};

class Campaign {
 public:
  void leave_whole(const std::string& name, const ExactComplex& right) {
    ++unbroken_.tried;
    if (const std::string wrong = mutations::false_alarm(right); !wrong.empty()) {
      ++unbroken_.missed;
      show(name + ", unbroken", wrong);
    }
  }

  void test(const std::string& name, const ExactComplex& right, unsigned seed) {
    leave_whole(name, right);
    const mutations::Right whole(right, seed);
    for (const mutations::Mutation& mutation : mutations::all()) {
      mutations::Right copy = whole;
      const auto broken = mutation.apply(copy);
      if (!broken) continue;
      Tally& tally = tally_[mutation.name];
      ++tally.tried;
      if (const std::string wrong = mutations::miss(right, *broken); !wrong.empty()) {
        ++tally.missed;
        show(name + ", " + mutation.name, wrong);
      }
    }
  }

  bool report() const {
    fmt::print("| result | tried | found and named right | missed |\n| --- | --- | --- | --- |\n");
    bool all_found = unbroken_.missed == 0;
    for (const mutations::Mutation& mutation : mutations::all()) {
      const auto found = tally_.find(mutation.name);
      const Tally tally = found == tally_.end() ? Tally{} : found->second;
      fmt::print("| {} | {} | {} | {} |\n", mutation.name, tally.tried, tally.tried - tally.missed,
                 tally.missed);
      all_found = all_found && tally.missed == 0;
    }
    fmt::print("\n{} unbroken results, {} with a finding.\n", unbroken_.tried, unbroken_.missed);
    return all_found;
  }

 private:
  void show(const std::string& title, const std::string& wrong) {
    if (++shown_ <= kMostShown) fmt::print(stderr, "{}:\n{}\n", title, wrong);
  }

  Tally unbroken_;
  std::map<std::string, Tally> tally_;
  std::size_t shown_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const unsigned long first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  if (count == 0) {
    fmt::print(stderr, "usage: plumbline_mutations COUNT [FIRST-SEED [FILE...]]\n");
    return 2;
  }
  Campaign campaign;
  const std::vector<std::string>& families = inputs::families();
  for (unsigned long i = 0; i < kUnbroken * count; ++i) {
    const std::string& family = families[i % families.size()];
    const auto seed = static_cast<unsigned>(first + i / families.size());
    const ExactComplex right = arrange(inputs::of_family(family, seed));
    if (right.vertices.size() > kMostVertices) continue;
    const std::string name = fmt::format("family \"{}\", seed {}", family, seed);
    if (i < count) {
      campaign.test(name, right, seed);
    } else {
      campaign.leave_whole(name, right);
    }
  }
  for (int i = 3; i < argc; ++i) {
    campaign.test(argv[i], arrange(evaluate(read(argv[i]))), static_cast<unsigned>(first));
  }
  return campaign.report() ? 0 : 1;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
