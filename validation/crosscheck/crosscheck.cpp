// Every readable file below a directory through `check`: three answers side by side, the findings
// by kind and by the stage that made them.
// Usage: plumbline_crosscheck DIRECTORY. Prints Markdown; exit code 1 if a finding has no cause.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>

#include "plumbline/plumbline.hpp"

namespace fs = std::filesystem;
using namespace plumbline;

namespace {

using Tally = std::map<std::string, std::size_t>;

struct Totals {
  std::size_t files = 0, agreeing = 0, findings = 0, converted = 0, unattributed = 0, invalid = 0;
  Tally causes, kinds;
};

std::string text(const Tally& tally) {
  std::vector<std::pair<std::string, std::size_t>> rows(tally.begin(), tally.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string result;
  for (const auto& [name, count] : rows) {
    result += fmt::format("{}{} {}", result.empty() ? "" : ", ", count, name);
  }
  return result;
}

std::string text(const Counts& c) {
  return fmt::format("{} {} {} {} {}", c.vertices, c.edges, c.faces, c.holes, c.depth);
}

/// "prune 12, intersect 3": by stage in the row, by stage and rule in the totals.
void tally(const std::vector<Finding>& findings, const std::vector<Cause>& causes, Tally& stages,
           Totals& totals) {
  for (const Finding& finding : findings) {
    ++totals.kinds[to_text(finding.kind) + " " + to_text(finding.disagreement)];
  }
  for (const Cause& cause : causes) {
    ++stages[cause.stage];
    ++totals.causes[cause.stage + ": " + cause.rule];
  }
  totals.unattributed += findings.size() - causes.size();
}

std::vector<fs::path> files_below(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A run of the campaign. The published pipeline has an absolute radius and decimals: it gets the
/// drawings mapped to the unit square.
struct Campaign {
  std::string title;
  std::optional<double> relative_radius;  ///< none: the published pipeline

  bool is_published() const { return !relative_radius; }
};

/// One row, and what it adds to the totals.
std::string row(const Structure& structure, const std::string& name, const Campaign& run,
                Totals& totals) {
  SegmentSet input = evaluate(structure);
  CheckOptions options;
  Engine engine = lar::engine();
  Parameters parameters;
  if (run.is_published()) {
    input = lar::to_unit_square(input);
    engine = inters::engine();
  } else {
    parameters["radius"] =
        lar::arrange(input).trace.radius / lar::kDefaultRelativeRadius * *run.relative_radius;
    options.parsed = [&] { return evaluate_rounded(structure); };
  }
  ExactComplex complex = arrange(input);
  const std::size_t segments = input.segments.size();
  const auto start = std::chrono::steady_clock::now();
  Answer answer = answer_of(engine, input, parameters);
  const Check result = check(std::move(input), std::move(complex), std::move(answer), options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;

  Tally stages;
  tally(result.comparison.findings, result.causes, stages, totals);
  Tally conversion;
  Totals of_conversion;
  tally(result.conversion.findings, result.conversion_causes, conversion, of_conversion);
  ++totals.files;
  totals.agreeing += result.agree();
  totals.converted += !result.conversion.agree();
  totals.findings += result.comparison.findings.size();
  totals.invalid += !result.comparison.float_valid;
  totals.unattributed += of_conversion.unattributed;
  const Comparison& c = result.comparison;
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {} | {:.2f} |\n", name, segments, text(c.exact_counts),
      result.conversion.agree() ? "same" : text(result.conversion.float_counts),
      c.agree() ? "same" : text(c.float_counts), text(stages), text(conversion), taken.count());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_crosscheck DIRECTORY\n";
    return 2;
  }
  std::size_t unattributed = 0;
  const std::vector<Campaign> runs = {
      {"Repaired, the publication's radius of 0.001 x longer side", lar::kDefaultRelativeRadius},
      {"Repaired, radius 1e-9 x longer side: joins what rounding took apart", 1e-9},
      {"Published, on the unit square", {}}};
  for (const Campaign& run : runs) {
    Totals totals;
    std::string rows;
    std::size_t unreadable = 0, refused = 0;
    for (const fs::path& file : files_below(argv[1])) {
      const std::string name = fs::relative(file, argv[1]).string();
      std::optional<Structure> structure;
      try {
        structure = read(file);
      } catch (const Error&) {
        ++unreadable;
        continue;
      }
      if (dimension(*structure) != 2) {
        ++unreadable;
        continue;
      }
      try {
        rows += row(*structure, name, run, totals);
      } catch (const Error& error) {
        rows += fmt::format("| {} | {} |\n", name, error.message());
        ++refused;
      }
    }
    unattributed += totals.unattributed;
    fmt::print(
        "## {}\n\n"
        "{} files ({} others are no drawings of the plane that a reader knows): {} agree; the "
        "float "
        "result of {} is no valid complex; rounding to doubles alone changes {}.\n{} findings, {} "
        "without a cause; {} files refused.\n\n- by kind: {}\n- by stage and rule: {}\n\n"
        "| file | segments | as authored: V E F holes depth | over doubles | float LAR | findings "
        "by stage | of rounding alone | s |\n|---|---:|---|---|---|---|---|---:|\n{}\n",
        run.title, totals.files, unreadable, totals.agreeing, totals.invalid, totals.converted,
        totals.findings, totals.unattributed, refused, text(totals.kinds), text(totals.causes),
        rows);
  }
  return unattributed == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
