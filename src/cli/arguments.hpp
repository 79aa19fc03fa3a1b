#pragma once

#include <string>
#include <variant>
#include <vector>

#include "cli/commands.hpp"

namespace plumbline::cli {

using Command = std::variant<ArrangeArguments, CheckArguments, MinimiseArguments, InfoArguments,
                             RoomsArguments, OverlayArguments, SelectArguments, CoverageArguments,
                             ValidityArguments, RepairArguments, LarArguments, EvalArguments,
                             RandomArguments, EnginesArguments, TileArguments>;

/// What is said instead of running: the help, the version, what others are made of.
struct Notice {
  std::string text;
  bool is_help = false;
};

inline constexpr std::size_t kMostColumns = 100;  ///< of the help

/// What the command line asks for, the program's name left out; its help has lines of so many
/// columns. Throws: Error BadInput for anything wrong, with what was probably meant.
std::variant<Command, Notice> parse(const std::vector<std::string>& arguments,
                                    std::size_t columns = kMostColumns);

}  // namespace plumbline::cli
