#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace plumbline::cli {

/// The manual page of the tool, or of the command of that name, for man(1).
std::string manual(const CLI::App& app, const std::string& command);

}  // namespace plumbline::cli
