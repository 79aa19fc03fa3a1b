// Text in, values out: nothing is printed, read or run here.

#include "cli/arguments.hpp"

#include <sstream>

#include "cli/options.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kDescription =
    "Exact planar arrangements of drawings, and a verdict on the float LAR result.\n\n"
    "  plumbline info plan.svg\n"
    "  plumbline arrange plan.svg -o plan.json\n"
    "  plumbline check plan.svg --picture check.svg\n"
    "  plumbline lar plan.svg --show components -o components.svg\n"
    "  plumbline eval table.json -o table.svg\n"
    "  plumbline random 5000 -o random.lines\n";
constexpr const char* kExitCodes =
    "Exit codes: 0 done or agree, 1 exact and float result disagree, 2 bad input (also where "
    "nothing of it, or not all that looks like geometry, is drawn: see --lenient) or usage, or a "
    "limit (--max-segments, --max-memory, --timeout), 3 internal; 130 after Ctrl-C, 143 after "
    "SIGTERM. However it ends, an output file is whole or not there.";

/// CLI11 would only say that a command is required.
void refuse_unknown_command(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return;
  const std::string& command = arguments[0];
  for (const char* known : {"arrange", "check", "eval", "info", "lar", "random"}) {
    if (command == known) return;
  }
  throw Error(ErrorCode::BadInput,
              "unknown command (the commands are arrange, check, eval, info, lar, random)", {},
              command);
}

/// Arguments are shown as they are, but for what a terminal would obey.
std::string shown(const std::string& text) {
  std::string result, line;
  for (std::istringstream lines(text); std::getline(lines, line);) result += line_text(line) + '\n';
  return result;
}

/// Of several drawings there is one line each. Throws: Error BadInput for outputs and the like.
template <class Arguments>
void check_several(const CLI::App& command, const Arguments& arguments) {
  if constexpr (std::is_base_of_v<InputArguments, Arguments>) {
    if (arguments.files.size() < 2) return;
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_type_name() != "FILE" || option->count() == 0) continue;
      throw Error(ErrorCode::BadInput,
                  option->get_name() + " is of one drawing; here are " +
                      std::to_string(arguments.files.size()),
                  {}, option->as<std::string>());
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

}  // namespace

std::variant<Command, Notice> parse(const std::vector<std::string>& arguments) {
  CLI::App app(kDescription, "plumbline");
  app.set_version_flag("--version", "plumbline " PLUMBLINE_VERSION);
  app.footer(kExitCodes);
  app.require_subcommand(1);
  ArrangeArguments arrange;
  CheckArguments check;
  InfoArguments info;
  LarArguments lar;
  EvalArguments eval;
  RandomArguments random;
  const std::pair arrange_command(add_command(app, arrange), &arrange);
  const std::pair check_command(add_command(app, check), &check);
  const std::pair info_command(add_command(app, info), &info);
  const std::pair lar_command(add_command(app, lar), &lar);
  const std::pair eval_command(add_command(app, eval), &eval);
  const std::pair random_command(add_command(app, random), &random);
  refuse_unknown_command(arguments);
  try {
    app.parse(std::vector(arguments.rbegin(), arguments.rend()));  // as CLI11 wants them: backwards
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool is_error = app.exit(error, out, err) != 0;
    return Notice{is_error ? shown(err.str()) : out.str(), is_error};
  }
  return called(arrange_command, check_command, info_command, lar_command, eval_command,
                random_command);
}

}  // namespace plumbline::cli
