#pragma once

#include <string>
#include <variant>
#include <vector>

#include "cli/commands.hpp"

namespace plumbline::cli {

using Command = std::variant<ArrangeArguments, CheckArguments, InfoArguments, LarArguments,
                             EvalArguments, RandomArguments>;

/// What is said instead of running: the help, the version, or what is wrong with the arguments.
struct Notice {
  std::string text;
  bool is_error = false;
};

/// What the command line asks for, the program's name left out. Throws: Error BadInput for an
/// unknown command and for what is no number.
std::variant<Command, Notice> parse(const std::vector<std::string>& arguments);

}  // namespace plumbline::cli
