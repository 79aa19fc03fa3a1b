#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/plumbline.hpp"

namespace plumbline::cli {
namespace {

std::string plural(std::size_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string sizes(std::span<const std::size_t> edges_of_components) {
  constexpr std::size_t kShown = 8;
  if (edges_of_components.empty()) return "no cycle";
  const auto shown = edges_of_components.first(std::min(kShown, edges_of_components.size()));
  return fmt::format("{} of {}{} edges", plural(edges_of_components.size(), "component"),
                     fmt::join(shown, ", "),
                     shown.size() < edges_of_components.size() ? ", ..." : "");
}

/// The radius that was asked for, of a drawing as the pipeline gets it; none: its own.
std::optional<double> radius_of(const LarArguments& arguments, const SegmentSet& input) {
  const std::string radius = arguments.radius.value_or("drawing");
  if (!is_preset(radius)) return nearest_double(parse_decimal(radius));
  return preset_radius(radius, arguments.unit_square ? lar::to_unit_square(input) : input);
}

/// "radius 0.5 (larlib)"
std::string radius_text(const LarArguments& arguments, double radius) {
  const std::string from = arguments.radius.value_or("drawing");
  return fmt::format("radius {}{}", shortest_text(radius),
                     is_preset(from) ? " (" + from + ")" : std::string());
}

void print(const LarArguments& arguments, const inters::Trace& trace, Report& report) {
  report.set("variant", "published");
  report.set("radius", trace.options.radius);
  report.set("vertices", trace.lar.vertices.size());
  report.set("edges", trace.lar.edges.size());
  report.set("clusters", trace.prune.clusters.size());
  report.print("variant      published: {} decimals, {}\n", trace.options.decimals,
               radius_text(arguments, trace.options.radius));
  report.print("lines        {}, {}\n", plural(trace.lines.size(), "segment"),
               plural(trace.intersection_points.size(), "intersection point"));
  report.print("lar          {} vertices, {} edges, {} clusters merged\n",
               trace.lar.vertices.size(), trace.lar.edges.size(), trace.prune.clusters.size());
  std::vector<std::size_t> edges;
  for (const auto& component : trace.components) edges.push_back(component.size());
  report.print("biconnected  {}; {} in no cycle\n", sizes(edges),
               plural(trace.bridges.size(), "edge"));
  if (trace.lar_from_lines) {
    const inters::Model& model = *trace.lar_from_lines;
    report.set("faces", model.faces.size());
    report.print("larFromLines {} vertices, {} edges, {} faces{}\n", model.vertices.size(),
                 model.edges.size(), model.faces.size(),
                 trace.largest->aborted ? ", the rest missing: the walk aborted" : "");
  } else {
    report.set("faces", Summary::Value());
    report.print("larFromLines none\n");
  }
  for (const inters::Failure& failure : trace.failures) {
    report.print("failed       {}: {} in {}: {}\n", failure.stage, failure.error, failure.function,
                 failure.message);
  }
}

void print(const LarArguments& arguments, const lar::Result& result, Report& report) {
  const lar::Trace& trace = result.trace;
  const lar::Graph& graph = trace.rounds.back().simplified;
  std::size_t clusters = 0, cuts = 0;
  for (const lar::Round& round : trace.rounds) {
    clusters += round.pruning.clusters.size();
    cuts += round.cuts.flat().size();
  }
  report.set("variant", "repaired");
  report.set("radius", trace.radius);
  report.set("rounds", trace.rounds.size());
  report.set("settled", trace.settled);
  report.set("clusters", clusters);
  const Counts counted = counts(result.complex, result.complex.vertices.size());
  set_counts(report, counted);
  report.print("variant      repaired: {}\n", radius_text(arguments, trace.radius));
  report.print("lines        {} distinct segments, {}, {}{}\n", trace.drawing.edges.size(),
               plural(cuts, "cut"), plural(trace.rounds.size(), "round"),
               trace.settled ? "" : ", not settled");
  report.print("lar          {} vertices, {} edges, {} clusters merged\n", graph.vertices.size(),
               graph.edges.size(), clusters);
  std::vector<std::size_t> edges;
  for (std::size_t c = 0; c < trace.biconnected.size(); ++c) {
    edges.push_back(trace.biconnected[c].size());
  }
  report.print("biconnected  {}; {} in no cycle\n", sizes(edges),
               plural(trace.bridges.size(), "edge"));
  report.print("complex      {}\n", counts_line(counted));
}

/// Whether the published pipeline has an answer, which may be that there is no face.
bool has_result(const inters::Trace& trace) {
  return trace.lar_from_lines || (trace.components.empty() && !trace.bridges.empty());
}

template <class Result>
void write_outputs(const LarArguments& arguments, const SegmentSet& input, const Result& result,
                   Report& report) {
  if (arguments.trace) write_file(*arguments.trace, to_json(result));
  LarPicture picture = arguments.picture;
  picture.y_up = arguments.unit_square != input.y_up;  // the map to the unit square turns y
  if (arguments.output) write_file(*arguments.output, to_svg(result, picture));
  print(arguments, result, report);
  for (const auto& file : {arguments.trace, arguments.output}) {
    if (file) report.say_written(*file);
  }
}

ExitCode run_published(const LarArguments& arguments, const SegmentSet& input, Report& report) {
  inters::Options options;
  options.decimals = arguments.decimals.value_or(inters::kDecimals);
  options.radius = radius_of(arguments, input).value_or(inters::kRadius);
  options.threads = arguments.threads;
  const inters::Trace trace = [&] {
    const Progress progress("running the published float LAR pipeline", arguments);
    return inters::run(arguments.unit_square ? inters::lines_on_unit_square(input, options.decimals)
                                             : inters::lines(input),
                       options);
  }();
  write_outputs(arguments, input, trace, report);
  if (has_result(trace)) return kAgree;
  throw Error(ErrorCode::BadInput, "the published pipeline fails on this drawing",
              {arguments.file, 0, 0}, trace.failures.empty() ? "" : trace.failures.front().message);
}

ExitCode run_repaired(const LarArguments& arguments, const SegmentSet& input, Report& report) {
  if (arguments.decimals) {
    throw Error(ErrorCode::BadInput,
                "decimals are the published variant's; this one rounds to doubles");
  }
  const lar::Result result = [&] {
    const Progress progress("running the float LAR pipeline", arguments);
    return lar::arrange(arguments.unit_square ? lar::to_unit_square(input) : input,
                        {radius_of(arguments, input), arguments.threads});
  }();
  write_outputs(arguments, input, result, report);
  return kAgree;
}

}  // namespace

ExitCode run(const LarArguments& arguments, Report& report) {
  if (!arguments.picture.faces.empty() && arguments.picture.show != LarShow::Boundary) {
    throw Error(ErrorCode::BadInput, "--faces belongs to --show boundary");
  }
  if (check_outputs(arguments.file, {{arguments.trace, {"json"}}, {arguments.output, {"svg"}}})) {
    report.leave_standard_output();
  }
  const SegmentSet input = [&] {
    const Progress progress("reading " + arguments.file, arguments);
    return evaluate(read(arguments.file, arguments.reading), limits_of(arguments));
  }();
  ensure_all_drawn(arguments, input);
  set_input(report, input);
  report.print("drawing      {}: {}\n{}", line_text(arguments.file), input_line(input),
               rejected_lines(input));
  return arguments.is_published ? run_published(arguments, input, report)
                                : run_repaired(arguments, input, report);
}

}  // namespace plumbline::cli
