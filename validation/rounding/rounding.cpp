// How many drawings of a directory stay what they are when they are rounded, and what snap rounding
// does to the others.
// Usage: plumbline_rounding DIRECTORY. Prints Markdown; exit code 1 where a rounding failed.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <set>

#include "plumbline/plumbline.hpp"

namespace fs = std::filesystem;
using namespace plumbline;

namespace {

const std::vector<Grid> kGrids{{}, {6}, {4}, {3}, {2}};
const std::set<std::string> kEndings{".svg",  ".svgz",    ".dxf", ".lines",
                                     ".json", ".geojson", ".wkt", ".csv"};
/// Times of smaller drawings are mostly noise.
constexpr std::size_t kTimedVertices = 1000;

/// What the drawings had in common with one grid.
struct Total {
  std::size_t kept = 0, on_uniform_grid = 0, snapped = 0;
  std::size_t merged_vertices = 0, bent_edges = 0, vanished_edges = 0, vanished_faces = 0,
              split_faces = 0;
  double largest_movement = 0, largest_bend = 0;    ///< in spacings
  std::vector<double> kept_ratios, snapped_ratios;  ///< time against that of arranging
};

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<fs::path> drawings(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file() && kEndings.count(entry.path().extension().string()) != 0) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// In spacings.
double relative(const Rational& squared, const Rounding& rounding) {
  return nearest_sqrt(squared / (rounding.spacing * rounding.spacing));
}

/// Rounds, counts, and says what happened in a cell of the table.
std::string cell(const ExactComplex& complex, const Grid& grid, double arrange_seconds,
                 Total& total) {
  const std::clock_t start = std::clock();
  const Rounding rounding = safely_rounded(complex, grid, {1, {}});
  const double ratio = seconds_since(start) / arrange_seconds;
  if (complex.vertices.size() >= kTimedVertices) {
    (rounding.has_same_incidences() ? total.kept_ratios : total.snapped_ratios).push_back(ratio);
  }
  const RoundingChanges c = changes(complex, rounding);
  const double movement = relative(c.largest_squared_movement(), rounding);
  total.largest_movement = std::max(total.largest_movement, movement);
  if (rounding.has_same_incidences()) {
    const bool is_plain = grid.decimals || rounding.method == RoundingMethod::NearestDoubles;
    ++(is_plain ? total.kept : total.on_uniform_grid);
    return is_plain ? "same" : "same, on a uniform grid";
  }
  ++total.snapped;
  total.largest_bend = std::max(total.largest_bend, relative(c.largest_squared_bend(), rounding));
  const std::size_t merged = complex.vertices.size() - rounding.complex.vertices.size();
  total.merged_vertices += merged;
  total.bent_edges += c.bent_edges.size();
  total.vanished_edges += c.vanished_edges.size();
  total.vanished_faces += c.vanished_faces.size();
  total.split_faces += c.split_faces.size();
  return fmt::format("-{} V, {} bent, -{} F", merged, c.bent_edges.size(), c.vanished_faces.size());
}

std::string ratios(std::vector<double> values) {
  if (values.empty()) return "-";
  std::sort(values.begin(), values.end());
  return fmt::format("{:.2g} .. {:.2g} .. {:.2g}", values.front(), values[values.size() / 2],
                     values.back());
}

void print_totals(const std::vector<Total>& totals) {
  fmt::print(
      "\n| grid | same incidences | snap rounded | vertices less | edges bent | edges vanished | "
      "faces vanished | faces split | largest movement | largest bend | time: same | time: snap "
      "rounded |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|---|\n");
  for (std::size_t g = 0; g < kGrids.size(); ++g) {
    const Total& t = totals[g];
    fmt::print(
        "| {} | {}{} | {} | {} | {} | {} | {} | {} | {:.4f} | {:.4f} | {} | {} |\n",
        to_text(kGrids[g]), t.kept + t.on_uniform_grid,
        t.on_uniform_grid > 0 ? fmt::format(" ({} on a uniform grid)", t.on_uniform_grid) : "",
        t.snapped, t.merged_vertices, t.bent_edges, t.vanished_edges, t.vanished_faces,
        t.split_faces, t.largest_movement, t.largest_bend, ratios(t.kept_ratios),
        ratios(t.snapped_ratios));
  }
}

/// The rows of the drawings that at least one grid changes.
bool print_rows(const fs::path& directory, std::vector<Total>& totals) {
  bool all_good = true;
  std::size_t count = 0;
  for (const fs::path& file : drawings(directory)) {
    SegmentSet input;
    ExactComplex complex;
    double seconds = 0;
    try {
      input = evaluate(read(file));
      const std::clock_t start = std::clock();
      complex = arrange(input, ExactEngine::Bucket, {1, {}});
      seconds = seconds_since(start);
    } catch (const Error&) {
      continue;  // no drawing, or one that the readers refuse: counted elsewhere
    }
    if (input.segments.empty()) continue;
    ++count;
    const std::string name = fs::relative(file, directory).string();
    std::string row = fmt::format("| {} | {} |", name, complex.vertices.size());
    bool is_changed = false;
    for (std::size_t g = 0; g < kGrids.size(); ++g) {
      std::string text;
      try {
        text = cell(complex, kGrids[g], seconds, totals[g]);
      } catch (const Error& error) {
        text = std::string("**") + error.what() + "**";
        all_good = false;
      }
      is_changed = is_changed || text != "same";
      row += " " + text + " |";
    }
    if (is_changed) fmt::print("{}\n", row);
  }
  fmt::print("\n{} drawings.\n", count);
  return all_good;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_rounding DIRECTORY\n";
    return 2;
  }
  std::vector<Total> totals(kGrids.size());
  fmt::print("| drawing | V |");
  for (const Grid& grid : kGrids) fmt::print(" {} |", to_text(grid));
  fmt::print("\n|---|---:|---|---|---|---|---|\n");
  const bool all_good = print_rows(argv[1], totals);
  print_totals(totals);
  return all_good ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
