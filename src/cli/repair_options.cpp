// The options of repair.

#include "cli/options.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// "auto", "off", or a number of 0 or more.
std::optional<Rational> tolerance(const std::string& name, const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (text == "off") return Rational(0);
  try {
    const Rational value = parse_decimal(text);
    if (sgn(value) >= 0) return value;
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::BadInput,
              name + " is a number of 0 or more, in drawing units, or auto, off", {}, text);
}

void add_tolerance(CLI::App& command, const std::string& name, std::optional<Rational>& value,
                   const std::string& what) {
  command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = tolerance(name, text); },
          what + " [default: auto]")
      ->type_name("SIZE");
}

/// One that is off unless it is given.
void add_size(CLI::App& command, const std::string& name, Rational& value,
              const std::string& what) {
  command
      .add_option_function<std::string>(
          name,
          [&value, name](const std::string& text) {
            const std::optional<Rational> size = tolerance(name, text);
            if (!size) throw Error(ErrorCode::BadInput, name + " has no automatic size", {}, text);
            value = *size;
          },
          what + " [default: off]")
      ->type_name("SIZE");
}

void add_tolerances(CLI::App& command, RepairOptions& options) {
  command.option_defaults()->group("Tolerances, in drawing units");
  // Options are taken in the order in which they are added: the following ones win.
  command
      .add_option_function<std::string>(
          "--tolerance",
          [&options](const std::string& text) {
            for (std::optional<Rational>* each :
                 {&options.weld, &options.grow, &options.trim, &options.sliver}) {
              *each = tolerance("--tolerance", text);
            }
          },
          "One number for --weld, --grow, --trim and --sliver; or auto: each is chosen from the "
          "drawing, and said, or is off where the drawing does not tell [default: auto]")
      ->type_name("SIZE");
  add_tolerance(command, "--weld", options.weld,
                "Lines that lie beside another one within this become one with it");
  add_tolerance(command, "--grow", options.grow,
                "Loose ends run straight on, at most so far, to what they meet first");
  add_tolerance(command, "--trim", options.trim,
                "Loose ends that reach no further than this beyond a junction go");
  add_tolerance(command, "--sliver", options.sliver,
                "Faces no wider than this go to their neighbours; nothing moves");
  add_size(command, "--snap", options.snap, "Ends this near to a vertex go there");
  add_size(command, "--simplify", options.simplify,
           "Vertices this near to the line between their neighbours go");
  command
      .add_option_function<std::string>(
          "--doors", [&options](const std::string& range) { options.doors = door_range(range); },
          "Openings as wide as that are closed by virtual lines, on a layer of their own [default: "
          "off]")
      ->type_name("LEAST..MOST");
}

void add_choices(CLI::App& command, RepairOptions& options) {
  command.option_defaults()->group("What may be edited");
  const auto add = [&command](const char* name, std::vector<std::string>& names, const char* what,
                              const char* type) {
    command.add_option(name, names, what)->delimiter(',')->allow_extra_args(false)->type_name(type);
  };
  add("--walls", options.walls,
      "Layers whose lines have doors and block them, with commas; * and ? stand for any "
      "characters [default: all layers]",
      "LAYERS");
  add("--anchor", options.anchors, "Layers that no edit touches and to which others go", "LAYERS");
  add("--except", options.except, "Elements that no edit touches, by their ids", "IDS");
}

void add_outputs(CLI::App& command, RepairArguments& arguments) {
  command.option_defaults()->group("Output");
  CLI::Option* output = add_output(
      command, arguments.output, arguments.format,
      "Write the repaired drawing; without it this is a dry run. A .lines file is exact, "
      "others have nearest doubles",
      repair_formats());
  command.add_flag("--dry-run", arguments.dry_run,
                   "Say what would be done; write no drawing, but the other files");
  command
      .add_option(
          "--log", arguments.log,
          "Write all edits, with lines before and after, and what was refused to a JSON file")
      ->type_name("FILE");
  command
      .add_option("--findings", arguments.findings,
                  "Write the edits as points: .geojson, .csv, .dxf (a layer for each kind) and the "
                  "like")
      ->type_name("FILE");
  command
      .add_option("--picture", arguments.picture,
                  "Draw what was added, removed and moved, and the faces that changed, to an SVG "
                  "file")
      ->type_name("FILE");
  command
      .add_option("--report", arguments.report,
                  "Write an HTML page: the drawing before and after, the edits to click through")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--undo", [&](const std::string& log) { arguments.undo = file_of(log); },
          "FILE is a repaired drawing and this the log of its repair: write to -o what it was made "
          "of")
      ->needs(output)
      ->excludes("--dry-run", "--log", "--findings", "--picture", "--report")
      ->type_name("LOG");
  command
      .add_flag(
          "--compare", arguments.compare,
          "Also tell what other rules make of the drawing at the same tolerance: LAR's pruning, "
          "gaps closed at a mean, all ends extended")
      ->excludes("--undo");
  command
      .add_option("--list", arguments.listed,
                  "Print the N edits that do most [default: as many as fit on a screen]")
      ->check(integer(0))
      ->type_name("N");
}

}  // namespace

CLI::App* add_command(CLI::App& app, RepairArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("repair", "Repair line work: a list of edits, and the drawing with them");
  command->footer(
      "Examples: plumbline repair plan.dxf\n"
      "          plumbline repair plan.dxf --report fixes.html\n"
      "          plumbline repair plan.dxf -o fixed.dxf --log fixes.json\n"
      "          plumbline repair plan.svg --tolerance 0.05 --weld off --doors 0.6..1.2\n"
      "          plumbline repair fixed.dxf --undo fixes.json -o plan.dxf\n"
      "Exit codes: 0 there is nothing left to say, 1 something was refused, 2 bad input.");
  add_file(*command, arguments);
  add_outputs(*command, arguments);
  add_tolerances(*command, arguments.repair);
  add_choices(*command, arguments.repair);
  add_reading(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
