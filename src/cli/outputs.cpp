#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/watchdog.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

namespace fs = std::filesystem;

/// Where the file is, or would be made: links followed, those that lead to nothing yet too.
fs::path place_of(const std::string& name) {
  constexpr int kMostLinks = 40;  // as kernels have it
  std::error_code ignored;
  // From the root on: weakly_canonical leaves alone what begins with a name that is not there.
  fs::path file = fs::absolute(name, ignored);
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, ignored)); ++i) {
    file = file.parent_path() / fs::read_symlink(file, ignored);
  }
  return fs::weakly_canonical(file, ignored);
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return place_of(a) == place_of(b) || fs::equivalent(a, b, ignored);
}

}  // namespace

bool is_standard_output(const std::string& file) {
  return file == "-" || file == "/dev/stdout" || file == "/dev/fd/1" || file == "/proc/self/fd/1";
}

std::string_view format_of(const Output& output) {
  const auto& known = output.formats;
  if (output.format) {
    const auto found = std::ranges::find(known, *output.format);
    if (found != known.end()) return *found;
    throw Error(ErrorCode::BadInput, "the format is " + listed(known), {}, *output.format);
  }
  if (const auto format = format_by_ending(*output.file, known)) return *format;
  std::error_code ignored;  // what is wrong with the name is told when it is written to
  const fs::file_status status = fs::status(*output.file, ignored);
  const bool is_device = fs::exists(status) && !fs::is_regular_file(status);
  if (is_standard_output(*output.file) || is_device) return known.front();
  throw Error(ErrorCode::BadInput,
              "an output file of this kind ends in " + listed_endings(known) +
                  (known.size() > 1 ? ", or --format names what it is" : ""),
              {}, *output.file);
}

bool check_outputs(const std::string& input, const std::vector<Output>& outputs) {
  std::vector<std::string> taken{input};
  bool is_stdout_taken = false;
  for (const Output& output : outputs) {
    if (!output.file) {
      if (!output.format) continue;
      throw Error(ErrorCode::BadInput, "--format is of an output, which -o names", {},
                  *output.format);
    }
    format_of(output);
    if (is_standard_output(*output.file)) {
      if (is_stdout_taken) {
        throw Error(ErrorCode::BadInput, "standard output takes one output", {}, *output.file);
      }
      is_stdout_taken = true;
      continue;
    }
    std::error_code ignored;
    const fs::file_status status = fs::status(*output.file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) continue;  // a pipe, a device
    for (const std::string& file : taken) {
      if (!is_same_file(*output.file, file)) continue;
      throw Error(ErrorCode::BadInput, "this output would overwrite the input or another output",
                  {}, *output.file);
    }
    taken.push_back(*output.file);
  }
  return is_stdout_taken;
}

void write_file(const std::string& file, std::string_view content) {
  if (is_standard_output(file)) {
    if (std::fwrite(content.data(), 1, content.size(), stdout) == content.size()) return;
    throw Error(ErrorCode::BadFile, "cannot write to standard output");
  }
  WatchedFile result(file);
  result.file().write(content);
  result.file().commit();
}

}  // namespace plumbline::cli
