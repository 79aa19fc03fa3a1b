// CPU times of both float pipelines beside the exact engines, in one run, as a Markdown table.
// Usage: plumbline_lar_times [WORKLOAD...]; without any, those of the recorded table.

#include <fmt/format.h>

#include <functional>

#include "inputs/workloads.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"
#include "times/table.hpp"

using namespace plumbline;

namespace {

const std::vector<std::string> kRecorded{"R5_5e3", "R1_1e5", "R1_1e6", "D_1e4",
                                         "S_1e4",  "G_300",  "Gr_300", "S1_1e4"};

/// Whether CGAL's sweep takes minutes: for many segments, and for many lines through one point.
bool takes_cgal_minutes(const std::string& workload, std::size_t segments) {
  return segments > 100'000 || (workload.starts_with("S1_") && segments > 1000);
}

std::string timed(const std::function<std::string()>& job) try {
  std::string cells;
  const double seconds = times::seconds([&] { cells = job(); });
  return fmt::format("{:.2f} s, {}", seconds, cells);
} catch (const Error& error) {
  return error.message();
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
}

}  // namespace

int main(int argc, char** argv) {
  return times::print_table(
      argc, argv, kRecorded,
      "| workload | segments | LAR as published | LAR repaired | bucket, 1 thread | CGAL |\n"
      "| --- | --- | --- | --- | --- | --- |\n",
      print_row);
}
