#pragma once

#include "cli/commands.hpp"

namespace plumbline::cli {

/// From here on, memory that cannot be had ends the program with an error, also where a library
/// would abort (GMP) or could not pass an exception on; so does more than the limit.
void limit_memory(const Limits& limits);

/// Whether the user limited it: then threads that cannot be had are a matter of memory, too.
bool is_memory_limited();

/// Ends the program with that error.
[[noreturn]] void end_without_memory();

}  // namespace plumbline::cli
