// Measures our engine against its peers on the workloads and writes the tables of
// validation/results/bench.md. Usage: plumbline_bench [--quick] [--data DIR] [--only TEXT]
//   --data DIR   the hospital drawings, for the workloads P
//   --only TEXT  the cases whose id contains TEXT
// Tables go to stdout, progress to stderr. Exit code 1 if an exact engine's counts are wrong or a
// case could not be run.

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "inputs/workloads.hpp"
#include "machine.hpp"
#include "table.hpp"
#include "timing.hpp"

using namespace plumbline;
using namespace plumbline::bench;

namespace {

struct Arguments {
  bool quick = false;
  std::string drawings, only;
  /// A case and a contender to run here, once, for a parent process.
  std::vector<std::string> measure;
};

bool parse(int argc, char** argv, Arguments& arguments) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--quick") {
      arguments.quick = true;
    } else if (word == "--data" && i + 1 < argc) {
      arguments.drawings = argv[++i];
    } else if (word == "--only" && i + 1 < argc) {
      arguments.only = argv[++i];
    } else if (word == "--measure" && i + 2 < argc) {
      arguments.measure = {argv[i + 1], argv[i + 2]};
      i += 2;
    } else {
      return false;
    }
  }
  return true;
}

const Contender& contender(const std::string& id) {
  const auto& all = contenders();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Contender& c) { return c.id == id; });
  if (found == all.end()) throw std::invalid_argument("no contender " + id);
  return *found;
}

/// What takes longer is run but once, in the process whose memory is measured.
constexpr double kTooLongToRepeat = 20;  // seconds

int repetitions(double seconds, bool quick) {
  if (quick) return 3;
  return seconds > 5 ? 1 : seconds > 1 ? 3 : 5;
}

Row run(const Case& input, const Arguments& arguments) {
  Row row{input, 0, {}, {}};
  for (const std::string& id : input.contenders) {
    std::vector<std::string> words{"--measure", input.id, id};
    if (arguments.quick) words.emplace_back("--quick");
    if (!arguments.drawings.empty()) words.insert(words.end(), {"--data", arguments.drawings});
    row.measures[id] = measure_in_fresh_process(words);
    const Measure& m = row.measures[id];
    fmt::print(stderr, "{}: {} {}\n", input.title, id,
               m.failure.empty() ? fmt::format("{:.3g} MB", m.peak / 1e6) : m.failure);
  }
  const SegmentSet segments = input.make();
  row.segments = segments.segments.size();
  std::vector<Timed> timed;
  for (const std::string& id : input.contenders) {
    const Measure& m = row.measures[id];
    const bool slow_peer = input.kind == Kind::Hostile && id == "cgal";
    if (!m.failure.empty() || slow_peer) continue;
    if (m.seconds > kTooLongToRepeat) {
      row.seconds[id] = m.seconds;
      continue;
    }
    timed.push_back(
        {&contender(id), contender(id).prepare(segments), repetitions(m.seconds, arguments.quick)});
  }
  row.seconds.merge(median_seconds(input.title, timed));
  return row;
}

/// Whether no exact engine has other cells than the exact ones.
bool right(const Row& row) {
  std::optional<Cells> exact = row.input.cells;
  for (const char* id : {"cgal", "bucket1", "bucket2", "text", "arrange"}) {
    const auto found = row.measures.find(id);
    if (found == row.measures.end() || !found->second.failure.empty()) continue;
    if (!exact) exact = found->second.cells;
    if (found->second.cells != *exact) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    fmt::print(stderr, "usage: plumbline_bench [--quick] [--data DIR] [--only TEXT]\n");
    return 2;
  }
  const std::vector<Case> all = cases(arguments.quick, arguments.drawings);
  if (!arguments.measure.empty()) {
    for (const Case& c : all) {
      if (c.id == arguments.measure[0]) measure_here(c, contender(arguments.measure[1]));
    }
    throw std::invalid_argument("no case " + arguments.measure[0]);
  }
  initialize_timing();
  const std::string facts = machine();
  if (arguments.drawings.empty()) {
    fmt::print(stderr, "no workloads P: --data DIR names the directory of the hospital drawings\n");
  } else {
    inputs::hospital(arguments.drawings);  // fails now rather than in an hour
  }
  std::vector<Row> rows;
  bool all_right = true;
  for (const Case& c : all) {
    if (c.id.find(arguments.only) == std::string::npos) continue;
    try {
      rows.push_back(run(c, arguments));
      all_right = all_right && right(rows.back());
    } catch (const std::exception& error) {  // the others' hour of work is not lost
      fmt::print(stderr, "{}: {}\n", c.title, error.what());
      all_right = false;
    }
  }
  fmt::print("{}\n{}", facts, tables(rows));
  return all_right ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "plumbline_bench: {}\n", error.what());
  return 2;
}
