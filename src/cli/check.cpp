#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "plumbline/engines/files.hpp"

namespace plumbline::cli {
namespace {

/// What --set says, and the short forms of it.
Parameters parameters_of(const CheckArguments& arguments, const Engine& engine) {
  Parameters parameters;
  const auto set = [&](const std::string& name, const std::string& text) {
    parameters[name] = parameter_value(engine, name, text);
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
  return parameters;
}

Answer answer_for(const CheckArguments& arguments, const Engine& engine, const Drawing& drawing) {
  const Parameters parameters = parameters_of(arguments, engine);
  return answer_of(arguments.with_svg2lines ? inters_with_svg2lines(drawing)
                                            : engine_for(engine, drawing, parameters),
                   drawing.input, parameters, arguments.threads);
}

Check compare(const CheckArguments& arguments, const std::vector<Engine>& engines) {
  // What is malformed is told at once, before the work.
  const Engine engine = engine_named(arguments.engine, engines);
  std::optional<Answer> answer;
  if (arguments.against) {
    answer = files::answer(files::read(*arguments.against));
  } else {
    parameters_of(arguments, engine);
  }
  if (arguments.with_svg2lines && arguments.engine != "inters") {
    throw Error(ErrorCode::BadInput, "--svg2lines belongs to --engine inters", {},
                arguments.engine);
  }
  Drawing drawing = load(arguments);
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
  return result.agree() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
