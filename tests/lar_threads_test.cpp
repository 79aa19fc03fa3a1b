// The float pipelines on several threads.

#include <catch2/catch.hpp>

#include "engines/lar/stages/parallel.hpp"
#include "inputs/workloads.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_show.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/output.hpp"

using namespace plumbline;

namespace {

// Random segments in many buckets, crowds of near vertices, long lines, and a pencil in one bucket
// that is cut into several tasks.
const char* const kWorkloads[] = {"R1_1e4", "R5_1e3", "D_1e3", "Gr_50", "S_1e3", "S1_1e3"};

}  // namespace

TEST_CASE("the repaired pipeline's stages do not depend on the number of threads") {
  const auto* const name = GENERATE(from_range(std::begin(kWorkloads), std::end(kWorkloads)));
  INFO(name);
  const SegmentSet input = inputs::workload(name);
  for (const double radius : {0.0, 0.01}) {
    const std::string alone = to_json(lar::arrange(input, {radius, 1}));
    for (const std::size_t threads : {2U, 3U, 8U}) {
      CHECK(to_json(lar::arrange(input, {radius, threads})) == alone);
    }
  }
}

TEST_CASE("the published pipeline's stages do not depend on the number of threads") {
  const auto* const name = GENERATE(from_range(std::begin(kWorkloads), std::end(kWorkloads)));
  INFO(name);
  const std::vector<SegmentD> lines = inters::lines(inputs::workload(name));
  const auto run = [&](std::size_t threads) {
    return to_json(inters::run(lines, {4, 0.001, threads}));
  };
  const std::string alone = run(1);
  for (const std::size_t threads : {2U, 3U, 8U}) CHECK(run(threads) == alone);
}

TEST_CASE("a failure in one block ends the loop and is thrown on, on any number of threads") {
  for (const std::size_t threads : {1U, 2U, 2000U}) {
    const auto run = [&] {
      lar::on_threads(threads, [&] {
        lar::for_blocks(100, 7, [](std::size_t begin, std::size_t) {
          if (begin == 49) throw Error(ErrorCode::Limit, "the eighth block");
        });
      });
    };
    CHECK_THROWS_WITH(run(), Catch::Contains("the eighth block"));
  }
}

TEST_CASE("blocks cover all indices once") {
  for (const std::size_t count : {0U, 1U, 99U, 100U, 101U}) {
    std::vector<int> times(count, 0);
    lar::for_blocks(count, 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++times[i];
    });
    CHECK(times == std::vector<int>(count, 1));
  }
}
