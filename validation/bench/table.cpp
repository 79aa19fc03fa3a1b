#include "table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace plumbline::bench {
namespace {

using Number = std::optional<double>;
using Words = std::vector<std::string>;

constexpr double kMega = 1e6, kNano = 1e9;

/// What CGAL's and GEOS's time is to be divided by ours, at least.
struct Aim {
  const char* workloads;  ///< a name or, with '_' at its end, a family
  double cgal_by_1, cgal_by_2, geos_by_2;
};
constexpr Aim kAims[] = {
    {"R1_1e5", 15, 25, 40}, {"R1_1e6", 15, 25, 40}, {"R1_5e6", 15, 25, 40}, {"R1_", 15, 25, 0},
    {"R5_", 15, 25, 0},     {"G_", 15, 25, 0},      {"Gr_", 15, 25, 0},     {"D_", 10, 16, 0},
    {"S_", 10, 16, 0},      {"P_", 10, 16, 0},      {"S1_1e4", 50, 0, 0},
};
constexpr double kAimGrowth = 1.5, kAimBytes = 250;
constexpr std::size_t kManyEdges = 1'000'000;

Aim aim_of(const std::string& workload) {
  for (const Aim& aim : kAims) {
    const std::string name = aim.workloads;
    if (name == workload || (name.ends_with('_') && workload.starts_with(name))) return aim;
  }
  return {"", 0, 0, 0};
}

std::string line(const Words& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

std::string head(const Words& titles) {
  return line(titles) + "|---" + [&] {
    std::string rest;
    for (std::size_t i = 1; i < titles.size(); ++i) rest += "|---:";
    return rest + "|\n";
  }();
}

std::string shown(Number x) { return x ? fmt::format("{:.3g}", *x) : "-"; }
std::string shown_whole(Number x) { return x ? fmt::format("{:.0f}", *x) : "-"; }

Number quotient(Number x, Number y) { return x && y && *y > 0 ? Number(*x / *y) : std::nullopt; }

Number seconds(const Row& row, const std::string& contender) {
  const auto found = row.seconds.find(contender);
  return found == row.seconds.end() ? std::nullopt : Number(found->second);
}

const Measure* measure(const Row& row, const std::string& contender) {
  const auto found = row.measures.find(contender);
  return found == row.measures.end() || !found->second.failure.empty() ? nullptr : &found->second;
}

Number peak(const Row& row, const std::string& contender) {
  const Measure* m = measure(row, contender);
  return m != nullptr ? Number(m->peak) : std::nullopt;
}

/// Seconds, or why there are none.
std::string time_cell(const Row& row, const std::string& contender) {
  if (const Number s = seconds(row, contender)) return shown(s);
  const auto found = row.measures.find(contender);
  if (found != row.measures.end()) {
    const Measure& m = found->second;
    if (m.failure == "time limit") return fmt::format("> {}", row.input.limit_seconds);
    return m.failure.empty() ? shown(m.seconds) : m.failure;
  }
  for (const Absent& absent : row.input.absent) {
    if (absent.contender == contender) return "not run: " + absent.reason;
  }
  return "-";
}

/// The exact cells: known beforehand, or else CGAL's.
std::optional<Cells> exact_cells(const Row& row) {
  if (row.input.cells) return row.input.cells;
  const Measure* cgal = measure(row, "cgal");
  return cgal != nullptr ? std::optional(cgal->cells) : std::nullopt;
}

/// "equal", or who differs from the exact cells and by what.
std::string agreement(const Row& row) {
  const std::optional<Cells> exact = exact_cells(row);
  if (!exact) return "not known";
  std::string text;
  for (const auto& [id, m] : row.measures) {
    if (!m.failure.empty() || m.cells == *exact) continue;
    const auto by = [](std::size_t x, std::size_t y) {
      return static_cast<std::int64_t>(x) - static_cast<std::int64_t>(y);
    };
    text += fmt::format("{}{} {:+}/{:+}/{:+}", text.empty() ? "" : ", ", id,
                        by(m.cells.vertices, exact->vertices), by(m.cells.edges, exact->edges),
                        by(m.cells.faces, exact->faces));
  }
  return text.empty() ? "equal" : text;
}

/// The cells that tables show: the exact ones, or those of our engine.
Cells shown_cells(const Row& row) {
  if (const auto exact = exact_cells(row)) return *exact;
  const Measure* ours = measure(row, "bucket1");
  return ours != nullptr ? ours->cells : Cells{};
}

double items(const Row& row) {
  return static_cast<double>(row.segments + shown_cells(row).vertices);
}

/// "18.2 (15)": a ratio and its aim; bold where it falls short.
std::string against(Number ratio, double aim) {
  if (!ratio || aim == 0) return shown(ratio);
  const std::string mark = *ratio >= aim ? "" : "**";
  return fmt::format("{}{}{} ({})", mark, shown(ratio), mark, aim);
}

std::string workload_line(const Row& row) {
  const Cells cells = shown_cells(row);
  const Number one = seconds(row, "bucket1"), two = seconds(row, "bucket2");
  const Number cgal = seconds(row, "cgal"), geos = seconds(row, "geos");
  const Aim aim = aim_of(row.input.id);
  return line({row.input.title, std::to_string(row.segments),
               row.input.crossings ? std::to_string(*row.input.crossings) : "-",
               std::to_string(cells.vertices), std::to_string(cells.edges),
               std::to_string(cells.faces), time_cell(row, "bucket1"), time_cell(row, "bucket2"),
               time_cell(row, "cgal"), time_cell(row, "geos"),
               against(quotient(cgal, one), aim.cgal_by_1),
               against(quotient(cgal, two), aim.cgal_by_2),
               against(quotient(geos, two), aim.geos_by_2), agreement(row)});
}

std::string cost_line(const Row& row) {
  Words words{row.input.title};
  for (const char* id : {"bucket1", "bucket2", "cgal", "geos"}) {
    const Number s = seconds(row, id);
    const Number time = s ? Number(*s * kNano) : std::nullopt;
    Number by_crossings;
    if (row.input.crossings) {
      by_crossings = static_cast<double>(row.segments + *row.input.crossings);
    }
    words.push_back(shown_whole(quotient(time, by_crossings)));
    words.push_back(shown_whole(quotient(time, items(row))));
  }
  return line(words);
}

std::string memory_line(const Row& row) {
  const auto edges = static_cast<double>(shown_cells(row).edges);
  Words words{row.input.title, shown_whole(edges)};
  for (const char* id : {"bucket1", "bucket2", "cgal", "geos"}) {
    const Number bytes = peak(row, id);
    words.push_back(shown(quotient(bytes, kMega)));
    words.push_back(shown_whole(quotient(bytes, edges)));
  }
  return line(words);
}

const Row* find(const std::vector<Row>& rows, const std::string& id) {
  for (const Row& row : rows) {
    if (row.input.id == id) return &row;
  }
  return nullptr;
}

std::string growth(const std::vector<Row>& rows) {
  const Row* small = find(rows, "R1_1e5");
  const Row* large = find(rows, "R1_5e6");
  if (small == nullptr || large == nullptr) return "";
  std::string text = "Growth of time per (n + V) from R1_1e5 to R1_5e6:";
  for (const char* id : {"bucket1", "bucket2"}) {
    const Number per_item = quotient(quotient(seconds(*large, id), items(*large)),
                                     quotient(seconds(*small, id), items(*small)));
    text += fmt::format(" {} {}x;", id, shown(per_item));
  }
  return text + fmt::format(" aim: at most {}x.\n\n", kAimGrowth);
}

std::string memory_verdict(const std::vector<Row>& rows) {
  Number worst;
  for (const Row& row : rows) {
    const std::size_t edges = shown_cells(row).edges;
    if (row.input.kind != Kind::Workload || edges < kManyEdges) continue;
    for (const char* id : {"bucket1", "bucket2"}) {
      const Number bytes = quotient(peak(row, id), static_cast<double>(edges));
      if (bytes && (!worst || *bytes > *worst)) worst = bytes;
    }
  }
  if (!worst) return "";
  return fmt::format("Most bytes per edge of ours, from {} edges on: {}; aim: at most {}.\n\n",
                     kManyEdges, shown_whole(worst), kAimBytes);
}

std::string text_line(const Row& row) {
  const double coordinates = 4 * static_cast<double>(row.segments);
  const Number read = seconds(row, "read");
  return line({row.input.title, shown_whole(coordinates), time_cell(row, "read"),
               shown(read ? quotient(*read * kNano, coordinates) : std::nullopt),
               time_cell(row, "text")});
}

/// Seconds of the engine and of a whole arrange; what that is in engines and the others in
/// arranges.
std::string command_line(const Row& row) {
  const Number arrange = seconds(row, "arrange");
  Words words{row.input.title, time_cell(row, "bucket1"), time_cell(row, "arrange"),
              shown(quotient(arrange, seconds(row, "bucket1")))};
  for (const char* id : {"json", "compact", "safe", "check_fine", "check"}) {
    const Number ratio = quotient(seconds(row, id), arrange);
    words.push_back(ratio ? shown(ratio) : time_cell(row, id));
  }
  return line(words);
}

/// The workload R1 whose number of segments is nearest, by ratio.
const Row* nearest_r1(const std::vector<Row>& rows, const Row& row) {
  const Row* best = nullptr;
  const auto distance = [&](const Row& r) {
    return std::abs(std::log(static_cast<double>(r.segments) / static_cast<double>(row.segments)));
  };
  for (const Row& r : rows) {
    if (r.input.kind != Kind::Workload || !r.input.id.starts_with("R1_")) continue;
    if (best == nullptr || distance(r) < distance(*best)) best = &r;
  }
  return best;
}

std::string hostile_line(const Row& row, const Row* r1) {
  const Cells cells = shown_cells(row);
  const Number time = quotient(seconds(row, "bucket1"), items(row));
  const Number bytes = quotient(peak(row, "bucket1"), items(row));
  Number r1_time, r1_bytes;
  if (r1 != nullptr) {
    r1_time = quotient(seconds(*r1, "bucket1"), items(*r1));
    r1_bytes = quotient(peak(*r1, "bucket1"), items(*r1));
  }
  return line({row.input.title, std::to_string(row.segments), std::to_string(cells.vertices),
               std::to_string(cells.edges), std::to_string(cells.faces), time_cell(row, "bucket1"),
               time_cell(row, "bucket2"), shown_whole(time ? Number(*time * kNano) : time),
               shown(quotient(time, r1_time)), shown_whole(bytes), shown(quotient(bytes, r1_bytes)),
               time_cell(row, "cgal"), agreement(row)});
}

/// A table with a note below it; nothing for a table without lines.
std::string section(const std::string& title, const Words& titles, const std::string& lines,
                    const std::string& note = "") {
  if (lines.empty()) return "";
  return "## " + title + "\n\n" + head(titles) + lines + "\n" + note;
}

}  // namespace

std::string tables(const std::vector<Row>& rows) {
  std::string times, costs, memory, texts, commands, hostile;
  for (const Row& row : rows) {
    if (row.input.kind == Kind::Workload) {
      times += workload_line(row);
      costs += cost_line(row);
      memory += memory_line(row);
    } else if (row.input.kind == Kind::Text) {
      texts += text_line(row);
    } else if (row.input.kind == Kind::Command) {
      commands += command_line(row);
    } else {
      hostile += hostile_line(row, nearest_r1(rows, row));
    }
  }
  return section("Times: seconds, and ratios with their aims in brackets, bold where short of it",
                 {"workload", "n", "K", "V", "E", "F", "1 thread", "2 threads", "CGAL", "GEOS",
                  "CGAL / 1 thread", "CGAL / 2 threads", "GEOS / 2 threads", "V/E/F"},
                 times, growth(rows)) +
         section("Nanoseconds per (n + K) and per (n + V)",
                 {"workload", "1 thread: n + K", "n + V", "2 threads: n + K", "n + V",
                  "CGAL: n + K", "n + V", "GEOS: n + K", "n + V"},
                 costs) +
         section("Peak memory: MB, and bytes per edge of the result",
                 {"workload", "E", "1 thread: MB", "per edge", "2 threads: MB", "per edge",
                  "CGAL: MB", "per edge", "GEOS: MB", "per edge"},
                 memory, memory_verdict(rows)) +
         section("From text in memory",
                 {"workload", "coordinates", "text to segments, s", "ns per coordinate",
                  "text to arrangement, 2 threads, s"},
                 texts) +
         section("Whole commands, one thread, from text to text: seconds, and ratios",
                 {"workload", "engine, s", "arrange, s", "/ engine", "-o x.json / arrange",
                  "--compact / arrange", "--safe --decimals 6 / arrange",
                  "check --radius 1e-9 / arrange", "check / arrange"},
                 commands) +
         section("Hostile inputs: one thread per (n + V), and as a multiple of the R1 nearest in n",
                 {"input", "n", "V", "E", "F", "1 thread, s", "2 threads, s", "ns per (n + V)",
                  "x R1", "bytes per (n + V)", "x R1", "CGAL, s, one run", "V/E/F"},
                 hostile);
}

}  // namespace plumbline::bench
