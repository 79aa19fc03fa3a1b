#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/formats.hpp"

namespace plumbline::cli {

/// A file that a command is asked to write: "-" is standard output.
struct Output {
  std::optional<std::string> file;
  std::vector<std::string_view> formats;   ///< that it may have; the first one where nothing tells
  std::optional<std::string> format = {};  ///< as --format has it
};

/// Whether that is standard output, by "-" or a name of it.
bool is_standard_output(const std::string& file);

/// The format that --format names, else that of the ending; of standard output, pipes and devices
/// without a known ending the first one. Throws: Error BadInput for another ending or name.
std::string_view format_of(const Output& output);

/// Refuses, before any work, outputs of another format, or that would overwrite the input or each
/// other. Returns whether one of them is standard output. Throws: Error BadInput.
bool check_outputs(const std::string& input, const std::vector<Output>& outputs);

/// As plumbline::write_file, which it hides; leaves no temporary file if the program is ended.
void write_file(const std::string& file, std::string_view content);

}  // namespace plumbline::cli
