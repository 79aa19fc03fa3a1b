#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <string_view>

namespace plumbline::cli {

inline constexpr std::array kShells{"bash", "zsh", "fish"};

/// What completes the tool's commands, options, their values and files in one of kShells.
std::string completion(const CLI::App& app, std::string_view shell);

}  // namespace plumbline::cli
