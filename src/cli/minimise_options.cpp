// The command minimise.

#include "cli/options.hpp"

namespace plumbline::cli {
namespace {

void add_outputs(CLI::App& command, MinimiseArguments& arguments) {
  command.option_defaults()->group("Output");
  command
      .add_option("-o,--output", arguments.output,
                  "Write the smallest drawing to a .lines file; - is standard output, here and "
                  "below. An engine that is right leaves nothing to write")
      ->type_name("FILE");
  command
      .add_option("--report", arguments.report,
                  "Write an issue text for the engine's maintainers to a .md file: versions, the "
                  "input, what is expected, what comes out")
      ->type_name("FILE");
  command
      .add_option("--picture", arguments.picture,
                  "Draw the exact answer and the engine's to an SVG file, and what is too close to "
                  "be seen magnified")
      ->type_name("FILE");
}

void add_engine(CLI::App& command, MinimiseArguments& arguments) {
  command.option_defaults()->group("The engine");
  command.add_option("--engine", arguments.engine, "Its name, as of check [default: lar]")
      ->type_name("NAME:lar|inters|plasm");
  command
      .add_option("--set", arguments.settings,
                  "A parameter of the engine, as of check; it stays as it is")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  command
      .add_option("--tolerance", arguments.tolerance,
                  "Vertices match within this distance, in drawing units [default: as of check, "
                  "for each smaller drawing]")
      ->check(finite())
      ->type_name("T");
  command.option_defaults()->group("When to end");
  command
      .add_option("--seconds", arguments.seconds,
                  "End after so many seconds with the smallest drawing there is")
      ->check(positive())
      ->type_name("S");
  command
      .add_option("--max-runs", arguments.max_runs,
                  "End after so many runs of the engine with it [default: 20,000]")
      ->check(integer(1))
      ->type_name("N");
}

}  // namespace

CLI::App* add_command(CLI::App& app, MinimiseArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "minimise", "The fewest segments with which an engine is wrong as it is with the drawing");
  command->footer(
      "Examples: plumbline minimise plan.svg --engine lar --set radius=0.5\n"
      "          plumbline minimise plan.dxf --engine plasm -o case.lines --report issue.md "
      "--picture case.svg\n"
      "Numbers of the drawing count as their nearest doubles. What stays is the kind of the "
      "gravest difference: a face lost, edges that cross, an error of the engine. Then the exit "
      "code is 1, and 0 where the engine is right.");
  add_file(*command, arguments);
  add_outputs(*command, arguments);
  add_engine(*command, arguments);
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
