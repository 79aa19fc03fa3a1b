#pragma once

#include <functional>
#include <string>
#include <vector>

/// Tables of times, a row per workload.
namespace plumbline::times {

/// CPU seconds, of all threads together, that the job takes.
double seconds(const std::function<void()>& job);

/// Prints the head of a Markdown table and a row for each workload that the command line names, or
/// for each of `recorded` if it names none. The result is the exit code: 2, with a message, if a
/// row fails.
int print_table(int argc, char** argv, const std::vector<std::string>& recorded,
                const std::string& head, void (*print_row)(const std::string& workload));

}  // namespace plumbline::times
