#include "cli/program_folders.hpp"

#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>

namespace plumbline::cli {

std::vector<std::filesystem::path> program_folders() {
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    for (const char* const folder : {PLUMBLINE_LIBEXEC, "libexec/plumbline"}) {  // installed, built
      folders.push_back((tool.parent_path() / folder).lexically_normal());
    }
  }
  const char* const path = std::getenv("PATH");
  std::istringstream names(path == nullptr ? "" : path);
  for (std::string name; std::getline(names, name, ':');) {
    folders.emplace_back(name.empty() ? "." : name);  // as shells take it
  }
  return folders;
}

}  // namespace plumbline::cli
