#pragma once

#include <filesystem>
#include <vector>

namespace plumbline::cli {

/// Where programs that are engines are looked for: what is installed, or built, with the tool; then
/// the folders of PATH.
std::vector<std::filesystem::path> program_folders();

}  // namespace plumbline::cli
