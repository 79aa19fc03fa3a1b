// The short form; validation/mutations/run is the long one.

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "inputs/families.hpp"
#include "mutations/mutations.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

constexpr std::size_t kMostVertices = 60;

/// Breaks a right result in every way that it can be broken in; counts the ways.
void break_in_all_ways(const std::string& name, const ExactComplex& right, unsigned seed,
                       std::map<std::string, int>& count) {
  const mutations::Right whole(right, seed);
  for (const mutations::Mutation& mutation : mutations::all()) {
    mutations::Right copy = whole;
    const auto broken = mutation.apply(copy);
    if (!broken) continue;
    ++count[mutation.name];
    INFO(name << ", " << mutation.name);
    CHECK(mutations::miss(right, *broken) == "");
  }
}

const std::string kPlan = rectangle(0, 0, 20, 10) + "8 0 8 10  8 5 20 5  " + rectangle(1, 1, 3, 3) +
                          rectangle(4, 1, 7, 3) + rectangle(5, 2, 6, 3) +
                          "10 5 10 8  12 0 12 10  14 7 17 8  18 5 18.125 5.25  + 2 2  + 15 1";

}  // namespace

TEST_CASE("there are more than 20 ways to break a result, each with a name of its own") {
  std::set<std::string> names;
  for (const mutations::Mutation& mutation : mutations::all()) names.insert(mutation.name);
  CHECK(names.size() == mutations::all().size());
  CHECK(names.size() > 20);
}

TEST_CASE("a plan that is broken in any way is found out, by name and place") {
  const ExactComplex plan = arrange(segments(kPlan));
  std::map<std::string, int> count;
  for (unsigned seed = 1; seed <= 8; ++seed) break_in_all_ways("plan", plan, seed, count);
  for (const mutations::Mutation& mutation : mutations::all()) {
    INFO(mutation.name);
    CHECK(count[mutation.name] > 0);
  }
}

TEST_CASE("a random result that is broken in any way is found out, by name and place") {
  std::map<std::string, int> count;
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 101; seed <= 102; ++seed) {
      const ExactComplex right = arrange(inputs::of_family(family, seed));
      if (right.vertices.size() > kMostVertices) continue;
      break_in_all_ways(family + ' ' + std::to_string(seed), right, seed, count);
    }
  }
  CHECK(count.size() > 30);
}

TEST_CASE("an unbroken result raises no finding") {
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 201; seed <= 210; ++seed) {
      INFO(family << ' ' << seed);
      CHECK(mutations::false_alarm(arrange(inputs::of_family(family, seed))) == "");
    }
  }
  for (const char* file : {"dwelling.svg"}) {
    INFO(file);
    CHECK(mutations::false_alarm(
              arrange(evaluate(read(std::string(PLUMBLINE_EXAMPLES "/") + file)))) == "");
  }
}
