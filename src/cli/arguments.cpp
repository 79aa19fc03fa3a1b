// Text in, values out: nothing is printed, read or run here.

#include "cli/arguments.hpp"

#include <algorithm>
#include <sstream>

#include "cli/completion.hpp"
#include "cli/help.hpp"
#include "cli/manual.hpp"
#include "cli/options.hpp"
#include "cli/suggestions.hpp"
#include "cli/usage_error.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kDescription =
    "Exact planar arrangements of drawings, and a verdict on the float LAR result.\n\n"
    "  plumbline info plan.svg\n"
    "  plumbline arrange plan.svg -o plan.json\n"
    "  plumbline rooms plan.dxf -o rooms.geojson --picture rooms.svg\n"
    "  plumbline overlay parcels.geojson zones.geojson -o pieces.geojson\n"
    "  plumbline select plan.dxf \"WALLS - DOORS\" -o walls.geojson\n"
    "  plumbline coverage parcels.geojson --clean -o clean.geojson\n"
    "  plumbline validity parcels.geojson\n"
    "  plumbline repair plan.dxf -o fixed.dxf --log fixes.json\n"
    "  plumbline check plan.svg --picture check.svg\n"
    "  plumbline check plan.svg --engine geos\n"
    "  plumbline minimise plan.svg --engine lar -o case.lines --report issue.md\n"
    "  plumbline lar plan.svg --show components -o components.svg\n"
    "  plumbline eval table.json -o table.svg\n"
    "  plumbline random 5000 -o random.lines\n\n"
    "plumbline help COMMAND tells the options of a command.";
constexpr const char* kExitCodes =
    "Exit codes: 0 done or agree, 1 exact and float result disagree, or polygons have faults, 2 "
    "bad input (also where "
    "nothing of it, or not all that looks like geometry, is drawn: see --lenient) or usage, or a "
    "limit (--max-segments, --max-memory, --timeout), 3 internal; 130 after Ctrl-C, 143 after "
    "SIGTERM. However it ends, an output file is whole or not there.";

/// Of several drawings there is one line each. Throws: Error BadInput for outputs and the like.
template <class Arguments>
void check_several(const CLI::App& command, const Arguments& arguments) {
  if constexpr (std::is_base_of_v<InputArguments, Arguments>) {
    if (arguments.files.size() < 2) return;
    for (const CLI::Option* option : command.get_options()) {
      if (value_name(*option) != "FILE" || option->count() == 0) continue;
      throw Error(ErrorCode::BadInput, option->get_name() + " is of one drawing; here are " +
                                           std::to_string(arguments.files.size()));
    }
  }
}

/// The arguments of the command that was called.
template <class... Arguments>
Command called(std::pair<CLI::App*, Arguments*>... commands) {
  std::optional<Command> result;
  const auto take = [&](const CLI::App& command, auto& arguments) {
    if (!command.parsed()) return;
    check_several(command, arguments);
    result = std::move(arguments);
  };
  (take(*commands.first, *commands.second), ...);
  ensure(result.has_value(), "one command is called");
  return *std::move(result);
}

/// Hidden commands that print what is made from the options: for those who install them.
struct MadePages {
  explicit MadePages(CLI::App& app)
      : completion(app.add_subcommand("completion", "Print what completes commands in a shell")),
        manual(app.add_subcommand("man", "Print a manual page")) {
    completion->group("");
    manual->group("");
    completion->add_option("SHELL", shell)
        ->required()
        ->transform(one_of({kShells.begin(), kShells.end()}));
    manual->add_option("COMMAND", command)->transform(one_of(command_names(app)));
  }
  CLI::App* completion;
  CLI::App* manual;
  std::string shell, command;
};

/// The help comes last, and a flag takes no value.
void settle_flags(CLI::App& app) {
  app.set_help_flag("-h,--help", "Tell this");
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_help_flag("-h,--help", "Tell this")->group("Common");
    for (CLI::Option* option : command->get_options()) {
      if (option->get_expected_min() == 0) option->disable_flag_override();
    }
  }
}

/// "help" and "help COMMAND" in the words of options.
std::vector<std::string> without_help_command(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments[0] != "help") return arguments;
  std::erase(arguments, "help");
  arguments.resize(std::min<std::size_t>(arguments.size(), 1));
  arguments.emplace_back("--help");
  return arguments;
}

}  // namespace

std::variant<Command, Notice> parse(const std::vector<std::string>& given, std::size_t columns) {
  CLI::App app(kDescription, "plumbline");
  app.formatter(help_format(columns));
  ArrangeArguments arrange;
  CheckArguments check;
  MinimiseArguments minimise;
  InfoArguments info;
  RoomsArguments rooms;
  OverlayArguments overlay;
  SelectArguments select;
  CoverageArguments coverage;
  ValidityArguments validity;
  RepairArguments repair;
  LarArguments lar;
  EvalArguments eval;
  RandomArguments random;
  EnginesArguments engines;
  TileArguments tile;
  const std::pair arrange_command(add_command(app, arrange), &arrange);
  const std::pair check_command(add_command(app, check), &check);
  const std::pair minimise_command(add_command(app, minimise), &minimise);
  const std::pair info_command(add_command(app, info), &info);
  const std::pair rooms_command(add_command(app, rooms), &rooms);
  const std::pair overlay_command(add_command(app, overlay), &overlay);
  const std::pair select_command(add_command(app, select), &select);
  const std::pair coverage_command(add_command(app, coverage), &coverage);
  const std::pair validity_command(add_command(app, validity), &validity);
  const std::pair repair_command(add_command(app, repair), &repair);
  const std::pair lar_command(add_command(app, lar), &lar);
  const std::pair eval_command(add_command(app, eval), &eval);
  const std::pair random_command(add_command(app, random), &random);
  const std::pair engines_command(add_command(app, engines), &engines);
  const std::pair tile_command(add_command(app, tile), &tile);
  const MadePages pages(app);
  app.set_version_flag("-V,--version", "plumbline " PLUMBLINE_VERSION, "Tell the version");
  app.footer(kExitCodes);
  app.require_subcommand(1);
  settle_flags(app);
  const std::vector<std::string> arguments = without_help_command(given);
  check_command_is_known(app, arguments);
  try {
    app.parse(std::vector(arguments.rbegin(), arguments.rend()));  // as CLI11 wants them: backwards
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw usage_error(app, error);
    std::ostringstream text;
    app.exit(error, text, text);
    return Notice{text.str(), true};
  }
  if (pages.completion->parsed()) return Notice{completion(app, pages.shell), false};
  if (pages.manual->parsed()) return Notice{manual(app, pages.command), false};
  return called(arrange_command, check_command, minimise_command, info_command, rooms_command,
                overlay_command, select_command, coverage_command, validity_command, repair_command,
                lar_command, eval_command, random_command, engines_command, tile_command);
}

}  // namespace plumbline::cli
