#pragma once

#include <string>

#include "cli/commands.hpp"
#include "cli/load.hpp"

namespace plumbline::cli {

/// Whether a file of this ending holds features in doubles, which are written safely only.
bool is_of_features(const std::string& ending);

/// What `arrange` writes where it proves that the numbers are a valid complex: a .json, .svg or
/// .lines file with --safe, and files of features.
struct SafeOutput {
  std::string content;
  std::string line;  ///< for the terminal: what rounding did
};
/// Rounds the drawing and proves the result. Throws: Error.
SafeOutput safe_output(const ArrangeArguments& arguments, const Drawing& drawing);

}  // namespace plumbline::cli
