#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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

std::string ending(const std::string& file) {
  std::string text = fs::path(file).extension();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void check_outputs(const std::string& input, const std::vector<Output>& outputs) {
  std::vector<std::string> taken{input};
  for (const Output& output : outputs) {
    if (!output.file) continue;
    const auto& endings = output.endings;
    std::error_code ignored;  // what is wrong with the name is told when it is written to
    const fs::file_status status = fs::status(*output.file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) continue;  // a pipe, a device
    if (std::find(endings.begin(), endings.end(), ending(*output.file)) == endings.end()) {
      throw Error(ErrorCode::BadInput,
                  fmt::format("an output file of this kind ends in {}", fmt::join(endings, " or ")),
                  {}, *output.file);
    }
    for (const std::string& file : taken) {
      if (!is_same_file(*output.file, file)) continue;
      throw Error(ErrorCode::BadInput, "this output would overwrite the input or another output",
                  {}, *output.file);
    }
    taken.push_back(*output.file);
  }
}

void write_file(const std::string& file, std::string_view content) {
  WatchedFile result(file);
  result.file().write(content);
  result.file().commit();
}

void print_written(const std::string& file) { fmt::print("wrote {}\n", line_text(file)); }

}  // namespace plumbline::cli
