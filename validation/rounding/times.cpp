// What rounding costs beside arranging, on large inputs, as a Markdown table.
// Usage: plumbline_rounding_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include <ctime>
#include <iostream>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/round.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R1_1e4", "R1_7e4", "R5_2e4", "G_300",
                                         "Gr_300", "D_5e4",  "S_1e5",  "S1_1e4"};
const std::vector<Grid> kGrids{{}, {9}, {6}, {4}, {3}, {2}};

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string timed(const ExactComplex& complex, const Grid& grid) {
  const std::clock_t start = std::clock();
  const Rounding r = safely_rounded(complex, grid, {1, {}});
  const double seconds = seconds_since(start);
  if (r.has_same_incidences()) return fmt::format("{:.2f}, same", seconds);
  return fmt::format("{:.2f}, snap rounded to {} V", seconds, r.complex.vertices.size());
}

void print_row(const std::string& name) {
  const SegmentSet input = inputs::workload(name);
  const std::clock_t start = std::clock();
  const ExactComplex complex = arrange(input, ExactEngine::Bucket, {1, {}});
  const double arranging = seconds_since(start);
  const std::clock_t middle = std::clock();
  const bool is_valid = validate(complex).empty();
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} |", name, complex.vertices.size(),
             complex.edge_count(), arranging, seconds_since(middle));
  for (const Grid& grid : kGrids) fmt::print(" {} |", timed(complex, grid));
  fmt::print("{}\n", is_valid ? "" : " **invalid**");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> names =
      argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : kRecorded;
  fmt::print(
      "CPU seconds, one thread. `arrange`: from segments to the canonical exact complex.\n\n");
  fmt::print("| workload | V | E | arrange | validate |");
  for (const Grid& grid : kGrids) fmt::print(" {} |", to_text(grid));
  fmt::print("\n|---|---:|---:|---:|---:|---|---|---|---|---|---|\n");
  for (const std::string& name : names) print_row(name);
  return 0;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
