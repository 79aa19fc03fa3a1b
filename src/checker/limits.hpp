#pragma once

/// What the program may use. Beyond a limit it says so in a line and ends with exit code 2.
namespace plumbline_checker {

/// Ends it so where memory runs out, for `new` and for GMP, which would abort.
void end_where_memory_ends();

/// Sets the limit of a text "500M" or "4G" (K, M, G: powers of 1024; else bytes). False if it is
/// none. Requires: a text that outlives the program's memory, as arguments do.
bool limit_memory(const char* size);

/// Sets that of a number of seconds on the clock, above 0 and at most 1e9. False if it is none.
/// Requires: as above.
bool limit_time(const char* seconds);

}  // namespace plumbline_checker
