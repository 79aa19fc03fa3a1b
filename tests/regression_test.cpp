#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "campaign/judge.hpp"
#include "campaign/minimise.hpp"
#include "plumbline/arrange.hpp"

using namespace plumbline;

namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::filesystem::path kFolder = PLUMBLINE_REGRESSIONS;

std::map<std::string, SegmentSet> regressions() {
  std::map<std::string, SegmentSet> result;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".lines") {
      result[entry.path().filename().string()] = campaign::from_rows(content(entry.path()));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("nothing is wrong any more with the inputs of the regression corpus") {
  for (const auto& [name, input] : regressions()) {
    CAPTURE(name);
    for (const campaign::Relation relation : campaign::kRelations) {
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        CHECK(campaign::what_is_wrong(input, relation, seed) == "");
      }
    }
  }
}

TEST_CASE("the regression corpus has the counts that a program in fractions found") {
  std::string found;
  for (const auto& [name, input] : regressions()) {
    const ExactComplex c = arrange(input);
    found += name + " V " + std::to_string(c.vertices.size()) + " E " +
             std::to_string(c.edge_count()) + " F " + std::to_string(c.face_count()) + " C " +
             std::to_string(c.component_count()) + '\n';
  }
  CHECK(found == content(kFolder / "counts.txt"));
}
