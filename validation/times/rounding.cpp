// What rounding costs beside arranging, on large inputs, as a Markdown table.
// Usage: plumbline_rounding_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/round.hpp"
#include "times/table.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R1_1e4", "R1_7e4", "R5_2e4", "G_300",
                                         "Gr_300", "D_5e4",  "S_1e5",  "S1_1e4"};
const std::vector<Grid> kGrids{{}, {9}, {6}, {4}, {3}, {2}};

std::string timed(const ExactComplex& complex, const Grid& grid) {
  Rounding r;
  const double seconds = times::seconds([&] { r = safely_rounded(complex, grid, {1, {}}); });
  if (r.has_same_incidences()) return fmt::format("{:.2f}, same", seconds);
  return fmt::format("{:.2f}, snap rounded to {} V", seconds, r.complex.vertices.size());
}

void print_row(const std::string& name) {
  const SegmentSet input = inputs::workload(name);
  ExactComplex complex;
  bool is_valid = false;
  const double arranging = times::seconds([&] {
    complex = arrange(input, ExactEngine::Bucket, {1, {}});
  });
  const double validating = times::seconds([&] { is_valid = validate(complex).empty(); });
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} |", name, complex.vertices.size(),
             complex.edge_count(), arranging, validating);
  for (const Grid& grid : kGrids) fmt::print(" {} |", timed(complex, grid));
  fmt::print("{}\n", is_valid ? "" : " **invalid**");
}

}  // namespace

int main(int argc, char** argv) {
  std::string head =
      "CPU seconds, one thread. `arrange`: from segments to the canonical exact complex.\n\n"
      "| workload | V | E | arrange | validate |";
  for (const Grid& grid : kGrids) head += fmt::format(" {} |", to_text(grid));
  head += "\n|---|---:|---:|---:|---:|---|---|---|---|---|---|\n";
  return times::print_table(argc, argv, kRecorded, head, print_row);
}
