// CPU times of the comparison beside those of the exact arrangement, in one run, as a Markdown
// table. Usage: plumbline_crosscheck_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/lar.hpp"
#include "times/table.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R1_1e5", "R5_5e3", "D_1e5", "G_300"};
/// Only joins what rounding took apart; the workloads lie within 1 to 1000 units.
constexpr double kRadius = 1e-9;

void print_row(const std::string& name) {
  const SegmentSet input = inputs::workload(name);
  ExactComplex complex;
  FloatComplex floats;
  Comparison verdict;
  Check whole;
  const double arranging = times::seconds([&] {
    complex = arrange(input, ExactEngine::Bucket, {1, {}});
  });
  const double float_lar = times::seconds([&] {
    floats = lar::arrange(input, {kRadius, 1}).complex;
  });
  const double comparing = times::seconds([&] { verdict = compare(complex, floats, kRadius); });
  CheckOptions options;
  options.threads = 1;
  const double checking = times::seconds([&] {
    whole =
        check(input, complex, answer_of(lar::engine(), input, {{"radius", kRadius}}, 1), options);
  });
  fmt::print("| {} | {} | {:.2f} s | {:.2f} s | {} | {:.2f} s | {:.1f} | {:.2f} s | {:.1f} |\n",
             name, input.segments.size(), arranging, float_lar, verdict.findings.size(), comparing,
             comparing / arranging, checking, checking / arranging);
}

}  // namespace

int main(int argc, char** argv) {
  return times::print_table(
      argc, argv, kRecorded,
      "| workload | segments | `arrange` | `lar::arrange` | findings | `crosscheck` | ratio | "
      "`check` | ratio |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      print_row);
}
