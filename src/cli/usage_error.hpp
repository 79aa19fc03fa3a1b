#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "plumbline/error.hpp"

namespace plumbline::cli {

/// The names of the tool's commands that are not hidden.
std::vector<std::string> command_names(const CLI::App& app);

/// Refuses what does not begin with a command. Throws: Error BadInput, with what was probably
/// meant.
void check_command_is_known(const CLI::App& app, const std::vector<std::string>& arguments);

/// What is wrong with arguments that CLI11 refuses, in our words.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace plumbline::cli
