#pragma once

#include <string>

#include "cli/commands.hpp"
#include "cli/load.hpp"

namespace plumbline::cli {

/// What `arrange --safe` writes to a .json, .svg or .lines file.
struct SafeOutput {
  std::string content;
  std::string line;  ///< for the terminal: what rounding did
};
/// Rounds the drawing and proves the result. Throws: Error.
SafeOutput safe_output(const ArrangeArguments& arguments, const Drawing& drawing);

}  // namespace plumbline::cli
