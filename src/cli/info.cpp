#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// Some lines of a list, and how many more there are: with a diagnosis all is to fit on a screen.
std::string first_lines(const std::string& list) {
  constexpr std::ptrdiff_t kShown = 3;
  const auto count = std::count(list.begin(), list.end(), '\n');
  if (count <= kShown + 1) return list;
  std::size_t end = 0;
  for (std::ptrdiff_t i = 0; i < kShown; ++i) end = list.find('\n', end) + 1;
  return list.substr(0, end) +
         fmt::format("  ... and {} kinds more (without --diagnose all are told)\n", count - kShown);
}

void print_repetitions(const Drawing& drawing) {
  const Repetitions found = repetitions(drawing.input, drawing.complex);
  fmt::print("duplicates   {} segments repeat an earlier one\n", found.duplicates);
  fmt::print("overlaps     {} pairs of different segments share more than a point\n",
             found.overlaps);
  if (found.shared_sides > 0) {
    fmt::print(
        "neighbours   {} common sides of closed shapes are drawn by both, which is no defect\n",
        found.shared_sides);
  }
}

void print_extent(const ExactComplex& complex) {
  if (complex.vertices.empty()) return;
  Rational low = complex.vertices.front().y, high = low;
  for (const Point& p : complex.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  fmt::print("extent       x {} .. {}, y {} .. {}\n", exact_text(complex.vertices.front().x),
             exact_text(complex.vertices.back().x), exact_text(low), exact_text(high));
}

void print_features(const ExactComplex& complex) {
  if (complex.edge_count() == 0) return;
  const FeatureSize size = feature_size(complex);
  const auto distance = [](const Rational& squared) {
    const double rounded = nearest_sqrt(squared);
    return rounded > 0 ? fmt::format("{:.6g}", rounded) : std::string("less than 5e-324");
  };
  const auto at = [&](VertexId v) {
    const PointD p = nearest(complex.vertices[v]);
    return fmt::format("({}, {})", shortest_text(p.x), shortest_text(p.y));
  };
  fmt::print("features     nearest vertices {} apart, {} and {}\n",
             distance(size.squared_vertex_vertex), at(size.v), at(size.w));
  if (!size.edge.valid()) return;
  const Edge& edge = complex.edges[size.edge];
  fmt::print("             nearest vertex and edge {} apart, {} and {} - {}\n",
             distance(size.squared_vertex_edge), at(size.vertex), at(edge.tail), at(edge.head));
}

void print_ladder(const ExactComplex& complex, const std::optional<std::string>& plot) {
  const ToleranceLadder ladder = tolerance_ladder(complex);
  fmt::print("{}", to_text(ladder, complex));
  if (plot) write_file(*plot, to_svg(ladder));
}

void print_diagnosis(const Drawing& drawing, const InfoArguments& arguments) {
  const Diagnosis diagnosis = [&] {
    const Progress progress("diagnosing");
    DiagnoseOptions options;
    options.within = arguments.within;
    options.most_listed = std::max(options.most_listed, arguments.listed);
    options.doors = arguments.doors;
    return diagnose(drawing.input, drawing.complex, options);
  }();
  if (arguments.output) write_file(*arguments.output, to_json(diagnosis, drawing.input));
  if (arguments.picture) {
    write_file(*arguments.picture, to_svg(diagnosis, drawing.input, drawing.complex));
  }
  if (arguments.findings) write_file(*arguments.findings, to_geojson(diagnosis, drawing.input));
  fmt::print("\n{}", to_text(diagnosis, drawing.input, arguments.listed));
  if (arguments.listed == 0 && !diagnosis.defects.empty()) {
    fmt::print("all of them: --list N, --picture, --findings, -o\n");
  }
}

}  // namespace

ExitCode run(const InfoArguments& arguments) {
  check_outputs(arguments.file, {{arguments.plot, {".svg"}},
                                 {arguments.output, {".json"}},
                                 {arguments.picture, {".svg"}},
                                 {arguments.findings, {".geojson", ".json"}}});
  const Drawing drawing = load(arguments);
  fmt::print("drawing      {}: {} elements, {}\n", line_text(arguments.file),
             drawing.input.sources.size(), input_line(drawing.input));
  const std::string rejected = rejected_lines(drawing.input);
  fmt::print("{}", arguments.diagnose ? first_lines(rejected) : rejected);
  fmt::print("exactness    {}\n", exactness_line(drawing.input));
  print_extent(drawing.complex);
  print_repetitions(drawing);
  fmt::print("arrangement  {}\n", counts_line(drawing.complex, drawing.complex.vertices.size()));
  print_features(drawing.complex);
  if (const Drift found = drift(drawing.input, drawing.complex); found.places > 0) {
    fmt::print("drift        {}\n", to_text(found));
  }
  fmt::print("signature    {}\n", signature(drawing.complex));
  if (arguments.ladder || arguments.plot) print_ladder(drawing.complex, arguments.plot);
  if (arguments.diagnose) print_diagnosis(drawing, arguments);
  ensure_all_drawn(arguments, drawing.input);
  return kAgree;
}

}  // namespace plumbline::cli
