#pragma once

#include "cli/commands.hpp"

namespace plumbline::cli {

/// The tool: parses the arguments and runs what they ask for; `check` knows these engines by their
/// names. Returns the exit code; errors are told on standard error.
int run(int argc, char** argv, const KnownEngines& known);

}  // namespace plumbline::cli
