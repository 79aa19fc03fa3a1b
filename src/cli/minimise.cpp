#include "plumbline/minimise.hpp"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/engine_settings.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/output/minimised.hpp"

namespace plumbline::cli {
namespace {

Engine engine_of(const MinimiseArguments& arguments, const KnownEngines& known) {
  Engine engine = engine_named(arguments.engine, known.built_in, known.folders);
  if (engine.name == "files") {
    throw Error(ErrorCode::BadInput, "a result in a file can't be made again of fewer segments", {},
                engine.name);
  }
  return engine;
}

Minimised minimised_drawing(const MinimiseArguments& arguments, const Engine& engine) {
  engine_settings(arguments.settings, engine, {});  // refused before the work
  const Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, arguments.file, drawing.input.rejected,
                   drawing.input.segments.empty());
  const EngineSettings settings = engine_settings(arguments.settings, engine, drawing.input);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  MinimiseOptions options;
  options.tolerance = arguments.tolerance;
  options.max_runs = arguments.max_runs;
  options.threads = arguments.threads;
  options.enough = [&] {
    const std::chrono::duration<double> time = Clock::now() - start;
    return arguments.seconds && time.count() > *arguments.seconds;
  };
  Progress shown("minimising", arguments);
  options.progress = [&](std::size_t runs, std::size_t segments) {
    shown.tell(fmt::format("minimising: {} segments, run {} of {}", segments, runs, engine.name));
    return true;
  };
  return minimised(drawing.input, engine_for(engine, drawing, settings.parameters),
                   settings.parameters, options);
}

std::vector<std::string> rows_of(const Minimised& result) {
  std::vector<std::string> rows;
  std::istringstream text(to_lines(result));
  for (std::string row; std::getline(text, row);) rows.push_back(row);
  return rows;
}

void summarise(const Minimised& result, Report& report) {
  const bool is_right = result.outcome.outcome_class == OutcomeClass::Right;
  const Counts &exact = result.check.comparison.exact_counts,
               &answer = result.check.comparison.float_counts;
  report.set("agree", is_right);
  report.set("engine", result.engine);
  report.set("version", result.check.answer.version);
  report.set("outcome", to_text(result.outcome.outcome_class));
  report.set("kind", result.outcome.kind);
  report.set("segments", result.drawing.segments.size());
  report.set("segments_before", result.segments_before);
  report.set("runs", result.runs);
  report.set("one_minimal", result.is_one_minimal);
  report.set("simple_numbers", result.has_simple_numbers);
  report.set("representable", result.is_representable);
  report.set("tolerance", result.check.comparison.tolerance);
  if (result.check.answer.radius) report.set("radius", *result.check.answer.radius);
  if (result.radius_before) report.set("radius_before", *result.radius_before);
  report.set("vertices", exact.vertices);
  report.set("edges", exact.edges);
  report.set("faces", exact.faces);
  report.set("answer_vertices", answer.vertices);
  report.set("answer_edges", answer.edges);
  report.set("answer_faces", answer.faces);
  if (!is_right) report.set("lines", rows_of(result));
}

}  // namespace

ExitCode run(const MinimiseArguments& arguments, Report& report, const KnownEngines& known) {
  const bool on_stdout = check_outputs(arguments.file, {{arguments.output, {"lines"}},
                                                        {arguments.report, {"markdown"}},
                                                        {arguments.picture, {"svg"}}});
  if (on_stdout) report.leave_standard_output();
  const Minimised result = minimised_drawing(arguments, engine_of(arguments, known));
  const bool is_right = result.outcome.outcome_class == OutcomeClass::Right;
  const auto write = [&](const std::optional<std::string>& file, const auto& content) {
    if (!file || is_right) return;
    write_file(*file, content());
    report.note_written(*file);
  };
  write(arguments.output, [&] { return to_lines(result); });
  write(arguments.report, [&] {
    return to_issue(result, {arguments.output.value_or(""), arguments.picture.value_or("")});
  });
  write(arguments.picture, [&] { return to_svg(result); });
  summarise(result, report);
  const ExitCode code = is_right ? kAgree : kDisagree;
  report.print("{}", report.verdict(to_text(result), code));
  return code;
}

}  // namespace plumbline::cli
