// One row per drawing of a directory: the exact complex, the float LAR result, the verdict.
// Usage: plumbline_corpus DIRECTORY. Prints a Markdown table; exit code 1 if an exact result is
// invalid.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "plumbline/plumbline.hpp"

namespace fs = std::filesystem;
using namespace plumbline;

namespace {

/// A radius that only joins what rounding to doubles took apart, relative to the drawing's longer
/// side.
constexpr double kRoundingRadius = 1e-9;

std::string verdict(const ExactComplex& exact_complex, const SegmentSet& input, double radius) {
  const lar::Result lar = lar::arrange(input, {radius});
  const Comparison check = compare(exact_complex, lar.complex, radius);
  const Counts& c = check.float_counts;
  return fmt::format("{} {} {} | {}", c.vertices, c.edges, c.faces,
                     check.agree() ? "agree" : fmt::format("{} findings", check.findings.size()));
}

struct Row {
  std::string text;
  bool valid = true;
};

Row row(const fs::path& file, const std::string& name) {
  const SegmentSet input = evaluate(read(file));
  const ExactComplex complex = arrange(input);
  const bool valid = validate(complex).empty() && validate_coverage(complex, input).empty() &&
                     arrange(input, ExactEngine::Cgal) == complex;
  const Counts c = counts(complex, complex.vertices.size());
  const double radius = lar::arrange(input).trace.radius;
  return {
      fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name,
                  input.segments.size(), input.rejected.size(), c.vertices, c.edges, c.faces,
                  c.holes, c.depth, valid ? "yes" : "**NO**", verdict(complex, input, radius),
                  verdict(complex, input, radius / lar::kDefaultRelativeRadius * kRoundingRadius)),
      valid};
}

std::vector<fs::path> drawings(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".svg" || extension == ".lines") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_corpus DIRECTORY\n";
    return 2;
  }
  fmt::print(
      "| drawing | segments | rejected | V | E | F | holes | depth | valid | float V E F, radius "
      "0.001 | verdict | float V E F, radius 1e-9 | verdict |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---|---|---|---|---|\n");
  bool all_valid = true;
  for (const fs::path& file : drawings(argv[1])) {
    const std::string name = fs::relative(file, argv[1]).string();
    try {
      const Row result = row(file, name);
      fmt::print("{}", result.text);
      all_valid = all_valid && result.valid;
    } catch (const Error& error) {
      fmt::print("| {} | error: {} |\n", name, error.message());
      all_valid = false;
    }
  }
  return all_valid ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
