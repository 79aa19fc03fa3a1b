#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/engine_settings.hpp"
#include "cli/formats.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/engines/files.hpp"

namespace plumbline::cli {
namespace {

/// What --set says, and the short forms of it.
EngineSettings asked_of(const CheckArguments& arguments, const Engine& engine,
                        const SegmentSet& input) {
  std::vector<std::string> settings = arguments.settings;
  if (arguments.radius) settings.push_back("radius=" + *arguments.radius);
  if (arguments.decimals) settings.push_back("decimals=" + *arguments.decimals);
  if (arguments.result) settings.push_back("result=" + *arguments.result);
  return engine_settings(settings, engine, input);
}

Answer answer_for(const CheckArguments& arguments, const Engine& engine, const Drawing& drawing) {
  const EngineSettings asked = asked_of(arguments, engine, drawing.input);
  const bool is_program = engine.name != arguments.engine;  // given by its path
  Answer answer = answer_of(arguments.with_svg2lines ? inters_with_svg2lines(drawing)
                            : is_program             ? engine
                                         : engine_for(engine, drawing, asked.parameters),
                            drawing.input, asked.parameters, arguments.threads);
  const bool has_reason = asked.radius_from == "drawing" && !answer.radius_from.empty();
  if (answer.radius && !has_reason) answer.radius_from = asked.radius_from;
  return answer;
}

void choose_some_faces(Answer& answer) {
  if (answer.compared == Compared::Graph) {
    throw Error(ErrorCode::BadInput, "--some-faces is of a result with faces",
                {answer.title, 0, 0});
  }
  answer.compared = Compared::SomeFaces;
}

Check compare(const CheckArguments& arguments, const KnownEngines& known) {
  // What is malformed is told at once, before the work.
  const Engine engine = engine_named(arguments.engine, known.built_in, known.folders);
  std::optional<Answer> answer;
  if (arguments.against) {
    answer = files::answer(files::read(*arguments.against));
    ensure_all_drawn(arguments, *arguments.against, answer->dropped, false);
    if (arguments.some_faces) choose_some_faces(*answer);
  } else {
    asked_of(arguments, engine, {});
  }
  if (arguments.with_svg2lines && arguments.engine != "inters") {
    throw Error(ErrorCode::BadInput, "--svg2lines belongs to --engine inters", {},
                arguments.engine);
  }
  Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, arguments.file, drawing.input.rejected,
                   drawing.input.segments.empty());
  std::optional<Progress> shown;
  shown.emplace("running the engine " + arguments.engine, arguments);
  if (!answer) answer = answer_for(arguments, engine, drawing);
  return checked(std::move(drawing), std::move(*answer), arguments.tolerance, arguments.threads,
                 [&](const std::string& part) { shown.emplace(part, arguments); });
}

Check advised_as_asked(Check result, const CheckArguments& arguments) {
  Progress progress("looking for critical and right radii", arguments);
  AdviceOptions options;
  options.threads = arguments.threads;
  options.progress = [&](double part) {
    progress.tell(part);
    return true;
  };
  return with_advice(std::move(result), {arguments.advice, arguments.plot || arguments.report},
                     options);
}

void summarise(const Check& result, Report& report) {
  const Counts& exact = result.comparison.exact_counts;
  report.set("agree", result.agree());
  report.set("findings", result.comparison.findings.size());
  report.set("groups", result.groups.size());
  report.set("own_findings", result.own_findings());
  report.set("engine", result.answer.engine);
  if (result.answer.radius) report.set("radius", *result.answer.radius);
  set_input(report, result.input);
  set_counts(report, exact);
}

}  // namespace

ExitCode run(const CheckArguments& arguments, Report& report, const KnownEngines& known) {
  const bool on_stdout = check_outputs(arguments.file, {{arguments.output, {"json"}},
                                                        {arguments.picture, {"svg"}},
                                                        {arguments.report, {"html"}},
                                                        {arguments.plot, {"svg"}},
                                                        {arguments.findings, finding_formats()}});
  if (on_stdout) report.leave_standard_output();
  const Check result = advised_as_asked(compare(arguments, known), arguments);
  const auto write = [&](const std::optional<std::string>& file, const auto& content) {
    if (!file) return;
    write_file(*file, content());
    report.note_written(*file);
  };
  write(arguments.output, [&] { return to_json(result); });
  write(arguments.picture, [&] { return to_svg(result); });
  write(arguments.report, [&] { return to_html(result); });
  write(arguments.findings, [&] {
    return feature_file(format_of({arguments.findings, finding_formats()}),
                        {{finding_layer(result)}, result.input.crs, "", {}, result.input.unit});
  });
  write(arguments.plot, [&] { return to_svg(*result.ladder, result.right_radii); });
  const std::string text = to_text(result, arguments.listed);
  report.set_headline(text.substr(0, text.find('\n')));
  summarise(result, report);
  const bool is_whole = count_lost(result.input.rejected) == 0 && !result.input.segments.empty();
  const ExitCode code = result.agree() && is_whole ? kAgree : kDisagree;
  report.print("{}", report.verdict(text, code));
  return code;
}

}  // namespace plumbline::cli
