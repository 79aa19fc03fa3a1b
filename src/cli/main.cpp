#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <new>

#include "cli/commands.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kDescription =
    "Exact planar arrangements of drawings, and a verdict on the float LAR result.\n\n"
    "  plumbline info plan.svg\n"
    "  plumbline arrange plan.svg -o plan.json\n"
    "  plumbline check plan.svg --picture check.svg\n";
constexpr const char* kExitCodes =
    "Exit codes: 0 done or agree, 1 exact and float result disagree, 2 bad input or usage, 3 "
    "internal.";
constexpr const char* kFile = "A drawing: .svg or .lines (rows x1,y1,x2,y2)";

template <class Arguments>
CLI::App* add_command(CLI::App& app, Arguments& arguments, const char* name,
                      const char* description, const char* examples, ExitCode& exit_code) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer(examples);
  command->add_option("FILE", arguments.file, kFile)->required()->type_name("");
  command
      ->add_option_function<std::string>(
          "--engine",
          [&](const std::string& engine) {
            arguments.engine = engine == "cgal" ? Engine::Cgal : Engine::Bucket;
          },
          "Arrange with bucket (the default) or cgal (the reference, slower)")
      ->check(CLI::IsMember({"cgal", "bucket"}))
      ->type_name("ENGINE");
  command
      ->add_option("--threads", arguments.threads,
                   "Use at most N threads [default: one for each core]; never changes the result")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->add_flag("--verify", arguments.verify, "Arrange with both engines and compare");
  command->callback([&] { exit_code = run(arguments); });
  return command;
}

/// CLI11 would only say that a command is required.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string command = argv[1];
  if (command == "arrange" || command == "check" || command == "info") return;
  throw Error(ErrorCode::BadInput, "unknown command (the commands are arrange, check, info)", {},
              command);
}

ExitCode parse_and_run(int argc, char** argv) {
  ExitCode exit_code = kAgree;
  CLI::App app(kDescription, "plumbline");
  app.set_version_flag("--version", "plumbline " PLUMBLINE_VERSION);
  app.footer(kExitCodes);
  app.require_subcommand(1);

  ArrangeArguments arrange;
  CLI::App* command =
      add_command(app, arrange, "arrange", "Exact arrangement of a drawing: faces, holes, nesting",
                  "Example: plumbline arrange plan.svg -o plan.json", exit_code);
  command->add_option("-o,--output", arrange.output, "Write the complex to a .json or .svg file")
      ->type_name("FILE");

  CheckArguments check;
  command = add_command(
      app, check, "check", "Hold the float LAR result against the exact one",
      "Example: plumbline check plan.svg --radius 0.01 -o report.json --picture check.svg",
      exit_code);
  command
      ->add_option(
          "--radius", check.radius,
          "Float LAR merges vertices no further apart than this, in drawing units "
          "[default: 0.001 x the drawing's longer side; at least 2^-46 x its largest coordinate]")
      ->type_name("R");
  command
      ->add_option("--tolerance", check.tolerance,
                   "Vertices match within this distance, in drawing units [default: the radius]")
      ->type_name("T");
  command->add_option("-o,--output", check.output, "Write all findings to a JSON file")
      ->type_name("FILE");
  command
      ->add_option("--picture", check.picture, "Draw both results and the findings to an SVG file")
      ->type_name("FILE");

  InfoArguments info;
  add_command(app, info, "info", "What a drawing holds: counts, extent, repetitions, feature size",
              "Example: plumbline info plan.svg", exit_code);

  try {
    refuse_unknown_command(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kAgree : kBadInput;
  }
  return exit_code;
}

ExitCode guarded(int argc, char** argv) {
  try {
    const ExitCode code = parse_and_run(argc, argv);
    if (std::fflush(stdout) != 0)
      throw Error(ErrorCode::BadFile, "cannot write to standard output");
    return code;
  } catch (const Error& error) {
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return error.code() == ErrorCode::Internal ? kInternal : kBadInput;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "plumbline: out of memory\n");
    return kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumbline: internal error: {}\n", error.what());
    return kInternal;
  }
}

}  // namespace
}  // namespace plumbline::cli

int main(int argc, char** argv) { return plumbline::cli::guarded(argc, argv); }
