// CPU times of both float pipelines beside the exact engines, in one run, as a Markdown table.
// Usage: plumbline_lar_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <iostream>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R5_5e3", "R1_1e5", "R1_1e6", "D_1e4",
                                         "S_1e4",  "G_300",  "Gr_300", "S1_1e4"};

/// Whether CGAL's sweep takes minutes: for many segments, and for many lines through one point.
bool takes_cgal_minutes(const std::string& workload, std::size_t segments) {
  return segments > 100'000 || (workload.starts_with("S1_") && segments > 1000);
}

std::string timed(const std::function<std::string()>& job) {
  const std::clock_t start = std::clock();
  std::string cells;
  try {
    cells = job();
  } catch (const Error& error) {
    return error.message();
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return fmt::format("{:.2f} s, {}", seconds, cells);
}

std::string cells(std::size_t vertices, std::size_t edges, std::size_t faces) {
  return fmt::format("{} {} {}", vertices, edges, faces);
}

template <class P>
std::string cells(const CellComplex<P>& complex) {
  return cells(complex.vertices.size(), complex.edge_count(), complex.face_count());
}

std::string published_cells(const SegmentSet& input) {
  const inters::Trace trace = inters::run(inters::lines(input));
  const std::size_t faces = trace.lar_from_lines ? trace.lar_from_lines->faces.size() : 0;
  return cells(trace.lar.vertices.size(), trace.lar.edges.size(), faces + 1);
}

void print_row(const std::string& name) {
  const SegmentSet input = inputs::workload(name);
  const std::size_t n = input.segments.size();
  const ArrangeOptions one_thread{1, {}};
  fmt::print("| {} | {} | {} | {} | {} | {} |\n", name, n,
             timed([&] { return published_cells(input); }),
             timed([&] { return cells(lar::arrange(input, {0.0}).complex); }),
             timed([&] { return cells(arrange(input, ExactEngine::Bucket, one_thread)); }),
             takes_cgal_minutes(name, n) ? "" : timed([&] {
               return cells(arrange(input, ExactEngine::Cgal));
             }));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> names =
      argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : kRecorded;
  fmt::print(
      "| workload | segments | LAR as published | LAR repaired | bucket, 1 thread | CGAL |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : names) print_row(name);
  return 0;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
