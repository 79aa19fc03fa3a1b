#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::cli {

/// The ending of a file name, in lower case, with its dot.
std::string ending(const std::string& file);

/// A file that a command is asked to write, and the endings that it may have.
struct Output {
  const std::optional<std::string>& file;
  std::vector<std::string> endings;
};

/// Refuses, before any work, outputs of another ending, or that would overwrite the input or each
/// other. Throws: Error BadInput.
void check_outputs(const std::string& input, const std::vector<Output>& outputs);

/// As plumbline::write_file, which it hides; leaves no temporary file if the program is ended.
void write_file(const std::string& file, std::string_view content);

/// Says that the file is written.
void print_written(const std::string& file);

}  // namespace plumbline::cli
