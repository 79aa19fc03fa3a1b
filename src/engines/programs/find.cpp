#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <system_error>

#include "plumbline/engines/programs.hpp"

namespace plumbline::programs {

std::vector<Program> found_in(std::span<const std::filesystem::path> folders) {
  constexpr std::string_view kBegin = kPrefix;
  std::vector<Program> found;
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
      const std::string file = at->path().filename().string();
      std::error_code ignored;
      if (file.size() <= kBegin.size() || !file.starts_with(kBegin) ||
          !std::filesystem::is_regular_file(at->path(), ignored) ||
          ::access(at->path().c_str(), X_OK) != 0) {
        continue;
      }
      const std::string name = file.substr(kBegin.size());
      if (std::ranges::find(found, name, &Program::name) == found.end()) {
        found.push_back({name, at->path()});
      }
    }
  }
  std::ranges::sort(found, {}, &Program::name);
  return found;
}

}  // namespace plumbline::programs
