#pragma once

#include "cli/commands.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::cli {

/// `exact_answer` for the arguments, with its steps shown on the terminal.
Drawing load(const DrawingArguments& arguments);

}  // namespace plumbline::cli
