#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored) ||
         fs::equivalent(a, b, ignored);
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
    if (fs::exists(*output.file) && !fs::is_regular_file(*output.file))
      continue;  // a pipe, a device
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

}  // namespace plumbline::cli
