#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/formats.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
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

void print_repetitions(const Drawing& drawing, Report& report) {
  const Repetitions found = repetitions(drawing.input, drawing.complex);
  report.set("duplicates", found.duplicates);
  report.set("overlaps", found.overlaps);
  report.set("shared_sides", found.shared_sides);
  report.print("duplicates   {} segments repeat an earlier one\n", found.duplicates);
  report.print("overlaps     {} pairs of different segments share more than a point\n",
               found.overlaps);
  if (found.shared_sides > 0) {
    report.print(
        "neighbours   {} common sides of closed shapes are drawn by both, which is no defect\n",
        found.shared_sides);
  }
}

void print_layers(const SegmentSet& input, std::size_t shown, Report& report) {
  const std::vector<LayerCount> layers = layers_of(input);
  std::vector<Summary> all;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LayerCount& layer = layers[i];
    Summary summary;
    summary.set("name", layer.name);
    summary.set("segments", layer.segments);
    summary.set("texts", layer.texts);
    all.push_back(std::move(summary));
    if (i < shown) {
      report.print("{}{}: {} segments, {} texts\n", i == 0 ? "layers       " : "             ",
                   line_text(layer.name), layer.segments, layer.texts);
    }
  }
  if (layers.size() > shown) {
    report.print("             ... and {} more (--json has all)\n", layers.size() - shown);
  }
  report.set("layers", all);
}

void print_extent(const ExactComplex& complex, Report& report) {
  if (complex.vertices.empty()) return;
  Rational low = complex.vertices.front().y, high = low;
  for (const Point& p : complex.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const auto corner = [](const Rational& x, const Rational& y) {
    return std::vector<double>{nearest_double(x), nearest_double(y)};
  };
  report.set("low", corner(complex.vertices.front().x, low));
  report.set("high", corner(complex.vertices.back().x, high));
  report.print("extent       x {} .. {}, y {} .. {}\n", exact_text(complex.vertices.front().x),
               exact_text(complex.vertices.back().x), exact_text(low), exact_text(high));
}

void print_features(const ExactComplex& complex, Report& report) {
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
  report.set("nearest_vertices", nearest_sqrt(size.squared_vertex_vertex));
  report.print("features     nearest vertices {} apart, {} and {}\n",
               distance(size.squared_vertex_vertex), at(size.v), at(size.w));
  if (!size.edge.valid()) return;
  const Edge& edge = complex.edges[size.edge];
  report.set("nearest_vertex_and_edge", nearest_sqrt(size.squared_vertex_edge));
  report.print("             nearest vertex and edge {} apart, {} and {} - {}\n",
               distance(size.squared_vertex_edge), at(size.vertex), at(edge.tail), at(edge.head));
}

void print_ladder(const ExactComplex& complex, const std::optional<std::string>& plot,
                  Report& report) {
  const ToleranceLadder ladder = tolerance_ladder(complex);
  report.set("ladder_steps", ladder.steps.size());
  report.print("{}", to_text(ladder, complex));
  if (!plot) return;
  write_file(*plot, to_svg(ladder));
  report.note_written(*plot);
}

void print_diagnosis(const Drawing& drawing, const InfoArguments& arguments, Report& report) {
  const Diagnosis diagnosis = [&] {
    const Progress progress("diagnosing", arguments);
    DiagnoseOptions options;
    options.within = arguments.within;
    options.most_listed = std::max(options.most_listed, arguments.listed);
    options.doors = arguments.doors;
    return diagnose(drawing.input, drawing.complex, options);
  }();
  const auto write = [&](const std::optional<std::string>& file, const auto& content) {
    if (file) write_file(*file, content());
    if (file) report.note_written(*file);
  };
  write(arguments.output, [&] { return to_json(diagnosis, drawing.input); });
  write(arguments.picture, [&] { return to_svg(diagnosis, drawing.input, drawing.complex); });
  write(arguments.findings, [&] {
    return feature_file(
        format_of({arguments.findings, finding_formats()}),
        {{defect_layer(diagnosis, drawing.input)}, drawing.input.crs, "", {}, drawing.input.unit});
  });
  const std::size_t defects = std::reduce(diagnosis.found.begin(), diagnosis.found.end());
  report.set("defects", defects);
  report.set_headline(fmt::format("{}; {} defects", report.headline(), defects));
  report.print("\n{}", to_text(diagnosis, drawing.input, arguments.listed));
  if (arguments.listed == 0 && !diagnosis.defects.empty()) {
    report.print("all of them: --list N, --picture, --findings, -o\n");
  }
}

}  // namespace

ExitCode run(const InfoArguments& arguments, Report& report) {
  const bool on_stdout = check_outputs(arguments.file, {{arguments.plot, {"svg"}},
                                                        {arguments.output, {"json"}},
                                                        {arguments.picture, {"svg"}},
                                                        {arguments.findings, finding_formats()}});
  if (on_stdout) report.leave_standard_output();
  const Drawing drawing = load(arguments);
  const Counts counted = counts(drawing.complex, drawing.complex.vertices.size());
  const std::string signed_as = signature(drawing.complex);
  report.set_headline(counts_line(counted));
  report.set("elements", drawing.input.sources.size());
  set_input(report, drawing.input);
  set_counts(report, counted);
  report.set("signature", signed_as);
  report.print("drawing      {}: {} elements, {}\n", line_text(arguments.file),
               drawing.input.sources.size(), input_line(drawing.input));
  const std::string rejected = rejected_lines(drawing.input);
  report.print("{}", arguments.diagnose ? first_lines(rejected) : rejected);
  report.print("exactness    {}\n", exactness_line(drawing.input));
  print_extent(drawing.complex, report);
  print_layers(drawing.input, arguments.diagnose ? 3 : 16, report);
  print_repetitions(drawing, report);
  report.print("arrangement  {}\n", counts_line(counted));
  print_features(drawing.complex, report);
  if (const Drift found = drift(drawing.input, drawing.complex); found.places > 0) {
    report.print("drift        {}\n", to_text(found));
  }
  report.print("signature    {}\n", signed_as);
  if (arguments.ladder || arguments.plot) print_ladder(drawing.complex, arguments.plot, report);
  if (arguments.diagnose) print_diagnosis(drawing, arguments, report);
  ensure_all_drawn(arguments, drawing.input);
  return kAgree;
}

}  // namespace plumbline::cli
