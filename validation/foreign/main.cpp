// Every file below a directory of other libraries' test cases, as line work through both engines,
// the invariants, the checker and all relations. Usage: plumbline_foreign DIRECTORY. Prints
// markdown; exit code 1 if anything is wrong on our side, 2 if there are no files.

#include <fmt/format.h>

#include <algorithm>

#include "foreign/table.hpp"

using namespace plumbline;

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  if (argc == 2) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[1])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  if (files.empty()) {
    fmt::print(stderr, "usage: plumbline_foreign DIRECTORY, with files below it\n");
    return 2;
  }
  std::sort(files.begin(), files.end());
  std::vector<foreign::Row> rows;
  for (const std::filesystem::path& file : files) {
    rows.push_back(foreign::examined(file, file.lexically_relative(argv[1]).generic_string()));
  }
  fmt::print("{}", foreign::table(rows));
  const bool is_right =
      std::all_of(rows.begin(), rows.end(), [](const foreign::Row& row) { return row.is_right(); });
  return is_right ? 0 : 1;
}
