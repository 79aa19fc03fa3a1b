// One row per drawing of a directory: does the float LAR pipeline follow the exact tolerance
// ladder? It is run with a radius between each two of the first critical ones, on the edges of the
// exact complex and on the drawing, and its numbers of cells are compared with the ladder's, after
// its first round and at the end.
// Usage: plumbline_ladder STEPS FILE... Prints a Markdown table.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>

#include "plumbline/plumbline.hpp"

using namespace plumbline;

namespace {

struct Numbers {
  std::size_t vertices, edges, faces;

  std::string text() const { return fmt::format("{} {} {}", vertices, edges, faces); }
  friend bool operator==(const Numbers&, const Numbers&) = default;
};

/// Of a graph of the pipeline, faces by Euler's relation. An edge to itself is a point.
Numbers numbers(const lar::Graph& graph) {
  std::vector<std::size_t> parent(graph.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t components = parent.size(), edges = 0;
  for (const Edge& e : graph.edges) {
    if (e.tail == e.head) continue;
    ++edges;
    const std::size_t s = find(e.tail), t = find(e.head);
    if (s == t) continue;
    parent[s] = t;
    --components;
  }
  return {parent.size(), edges, 1 + components + edges - parent.size()};
}

Numbers numbers(const FloatComplex& complex) {
  return {complex.vertices.size(), complex.edge_count(), complex.face_count()};
}

/// The edges of the complex, and its isolated vertices.
SegmentSet edges_of(const ExactComplex& complex) {
  SegmentSet set;
  for (const Edge& e : complex.edges) {
    set.add({complex.vertices[e.tail], complex.vertices[e.head]}, SourceId{});
  }
  for (const VertexId v : complex.face_isolated_vertices.flat()) {
    set.add_point(complex.vertices[v], SourceId{});
  }
  return set;
}

/// How often the pipeline was as the ladder says.
struct Tally {
  std::size_t tried = 0;
  std::size_t arrangement = 0;              ///< first round, on the edges of the exact complex
  std::size_t first_round = 0, result = 0;  ///< on the drawing
  std::string first_difference;             ///< of the first of them

  void add(double radius, const Numbers& expected, const SegmentSet& edges,
           const SegmentSet& input) {
    const auto first_round_of = [](const lar::Result& run) {
      return numbers(run.trace.rounds.front().simplified);
    };
    const Numbers on_edges = first_round_of(lar::arrange(edges, {radius, 0}));
    const lar::Result run = lar::arrange(input, {radius, 0});
    ++tried;
    arrangement += on_edges == expected ? 1 : 0;
    first_round += first_round_of(run) == expected ? 1 : 0;
    result += numbers(run.complex) == expected ? 1 : 0;
    if (!(on_edges == expected) && first_difference.empty()) {
      first_difference =
          fmt::format("{:.6g}: {}, not {}", radius, on_edges.text(), expected.text());
    }
  }
};

std::string row(const std::filesystem::path& file, std::size_t steps) {
  // Steps nearer to each other than this say more of rounding than of the pipeline.
  constexpr double kApart = 1 + 1e-6;
  const SegmentSet input = evaluate(read(file));
  const ExactComplex complex = arrange(input);
  const SegmentSet edges = edges_of(complex);
  const ToleranceLadder ladder = tolerance_ladder(complex, {steps + 1, {}});
  Tally tally;
  Numbers expected{ladder.vertices, ladder.edges, ladder.faces};
  double last = 0;
  for (const LadderStep& step : ladder.steps) {
    const double radius = nearest_sqrt(step.squared_radius);
    if (radius > last * kApart) {
      tally.add(last == 0 ? radius / 2 : std::sqrt(last * radius), expected, edges, input);
    }
    expected = {step.vertices, step.edges, step.faces};
    last = radius;
  }
  const std::string first =
      ladder.steps.empty()
          ? "none"
          : fmt::format("{:.6g}", nearest_sqrt(ladder.steps.front().squared_radius));
  AdviceOptions options;
  options.ladder.max_steps = steps;
  const Check advice = advised(check(input, complex, answer_of(lar::engine(), input)), options);
  const RightRadii& right = *advice.right_radii;
  return fmt::format(
      "| {} | {} {} {} | {} | {} | {} | {} | {} | {} | {} |\n",
      (file.parent_path().filename() / file.filename()).string(), ladder.vertices, ladder.edges,
      ladder.faces, first,
      right.empty() ? "none" : fmt::format("{:.3g} .. {:.6g}", right.least, right.largest),
      tally.tried, tally.arrangement, tally.first_round, tally.result,
      tally.first_difference.empty() ? "-" : tally.first_difference);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: plumbline_ladder STEPS FILE...\n";
    return 2;
  }
  std::cout << "| drawing | V E F | first step | right radii | radii | arrangement, first round | "
               "drawing, first round | drawing, result | first difference of the arrangement |\n"
               "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (int i = 2; i < argc; ++i) std::cout << row(argv[i], std::stoul(argv[1])) << std::flush;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
