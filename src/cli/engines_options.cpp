// The command engines.

#include "cli/options.hpp"

namespace plumbline::cli {

CLI::App* add_command(CLI::App& app, EnginesArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "engines", "The engines that check knows, and the programs that are engines");
  command->footer(
      "Examples: plumbline engines\n"
      "          plumbline check plan.svg --engine geos --set configuration=unary-union\n"
      "Programs plumbline-engine-NAME are looked for beside the tool, in libexec/plumbline, and in "
      "the folders of PATH.");
  add_common(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
