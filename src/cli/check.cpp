#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "plumbline/engines/files.hpp"

namespace plumbline::cli {
namespace {

struct Asked {
  Parameters parameters;
  std::string radius_from = "drawing";
};

/// What --set says, and the short forms of it. Presets of the radius are for this input; without
/// one they are just known.
Asked asked_of(const CheckArguments& arguments, const Engine& engine, const SegmentSet& input) {
  Asked asked;
  Parameters& parameters = asked.parameters;
  const auto set = [&](const std::string& name, const std::string& text) {
    if (name == "radius") asked.radius_from = is_preset(text) ? text : "number";
    if (name != "radius" || !is_preset(text)) {
      parameters[name] = parameter_value(engine, name, text);
      return;
    }
    parameter_value(engine, name, "0");  // refused where the engine has no radius
    if (const auto radius = preset_radius(text, input)) parameters[name] = *radius;
  };
  for (const std::string& setting : arguments.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw Error(ErrorCode::BadInput, "--set needs NAME=VALUE", {}, setting);
    }
    set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  if (arguments.radius) set("radius", *arguments.radius);
  if (arguments.decimals) set("decimals", *arguments.decimals);
  if (arguments.result) set("result", *arguments.result);
  return asked;
}

Answer answer_for(const CheckArguments& arguments, const Engine& engine, const Drawing& drawing) {
  const Asked asked = asked_of(arguments, engine, drawing.input);
  Answer answer =
      answer_of(arguments.with_svg2lines ? inters_with_svg2lines(drawing)
                                         : engine_for(engine, drawing, asked.parameters),
                drawing.input, asked.parameters, arguments.threads);
  if (answer.radius) answer.radius_from = asked.radius_from;
  return answer;
}

void choose_some_faces(Answer& answer) {
  if (answer.compared == Compared::Graph) {
    throw Error(ErrorCode::BadInput, "--some-faces is of a result with faces",
                {answer.title, 0, 0});
  }
  answer.compared = Compared::SomeFaces;
}

Check compare(const CheckArguments& arguments, const std::vector<Engine>& engines) {
  // What is malformed is told at once, before the work.
  const Engine engine = engine_named(arguments.engine, engines);
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
  std::optional<Progress> shown("running the engine " + arguments.engine);
  if (!answer) answer = answer_for(arguments, engine, drawing);
  return checked(std::move(drawing), std::move(*answer), arguments.tolerance, arguments.threads,
                 [&](const std::string& part) { shown.emplace(part); });
}

Check advised_as_asked(Check result, const CheckArguments& arguments) {
  Progress progress("looking for critical and right radii");
  AdviceOptions options;
  options.threads = arguments.threads;
  options.progress = [&](double part) {
    progress.tell(part);
    return true;
  };
  return with_advice(std::move(result), {arguments.advice, arguments.plot || arguments.report},
                     options);
}

}  // namespace

ExitCode run(const CheckArguments& arguments, const std::vector<Engine>& engines) {
  check_outputs(arguments.file, {{arguments.output, {".json"}},
                                 {arguments.picture, {".svg"}},
                                 {arguments.report, {".html"}},
                                 {arguments.plot, {".svg"}},
                                 {arguments.findings, {".geojson", ".json"}}});
  const Check result = advised_as_asked(compare(arguments, engines), arguments);
  if (arguments.output) write_file(*arguments.output, to_json(result));
  if (arguments.picture) write_file(*arguments.picture, to_svg(result));
  if (arguments.report) write_file(*arguments.report, to_html(result));
  if (arguments.findings) write_file(*arguments.findings, to_geojson(result));
  if (arguments.plot) write_file(*arguments.plot, to_svg(*result.ladder, result.right_radii));
  fmt::print("{}", to_text(result, arguments.listed));
  const bool is_whole = count_lost(result.input.rejected) == 0 && !result.input.segments.empty();
  return result.agree() && is_whole ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
