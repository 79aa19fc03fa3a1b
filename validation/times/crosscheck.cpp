// CPU times of the comparison beside those of the exact arrangement, in one run, as a Markdown
// table. Usage: plumbline_crosscheck_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <iostream>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/lar.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R1_1e5", "R5_5e3", "D_1e5", "G_300"};
/// Only joins what rounding took apart; the workloads lie within 1 to 1000 units.
constexpr double kRadius = 1e-9;

double seconds(const std::function<void()>& job) {
  const std::clock_t start = std::clock();
  job();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void print_row(const std::string& name) {
  const SegmentSet input = inputs::workload(name);
  ExactComplex complex;
  FloatComplex floats;
  Comparison verdict;
  Check whole;
  const double arranging = seconds([&] { complex = arrange(input, ExactEngine::Bucket, {1, {}}); });
  const double float_lar = seconds([&] { floats = lar::arrange(input, {kRadius, 1}).complex; });
  const double comparing = seconds([&] { verdict = compare(complex, floats, kRadius); });
  CheckOptions options;
  options.threads = 1;
  const double checking = seconds([&] {
    whole =
        check(input, complex, answer_of(lar::engine(), input, {{"radius", kRadius}}, 1), options);
  });
  fmt::print("| {} | {} | {:.2f} s | {:.2f} s | {} | {:.2f} s | {:.1f} | {:.2f} s | {:.1f} |\n",
             name, input.segments.size(), arranging, float_lar, verdict.findings.size(), comparing,
             comparing / arranging, checking, checking / arranging);
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = kRecorded;
  fmt::print(
      "| workload | segments | `arrange` | `lar::arrange` | findings | `comparison` | ratio | "
      "`check` "
      "| ratio |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::string& name : names) print_row(name);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
