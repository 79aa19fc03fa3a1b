// The report for a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "output/text/ladder.hpp"
#include "output/text/terminal.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownRejected = 5;
constexpr std::size_t kShownBounds = 4;
constexpr std::size_t kShownKinds = 4;
constexpr std::size_t kShownSteps = 5;

void append_cell_counts(std::string& text, const Check& check) {
  const Comparison& c = check.comparison;
  text += fmt::format("\n{:<18}{:>13}{:>14}{:>12}\n", "", "as authored", "over doubles",
                      check.answer.short_title);
  for (const CountRow& row : count_rows()) {
    std::string name = row.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    const bool is_of_graph = name == "vertices" || name == "edges" || name == "components";
    const bool is_known = c.compared == Compared::All || is_of_graph;
    text += fmt::format("{:<18}{:>13}{:>14}{:>12}\n", name, c.exact_counts.*row.member,
                        check.conversion.float_counts.*row.member,
                        is_known ? std::to_string(c.float_counts.*row.member) : "-");
  }
  text += "(faces with the unbounded one, holes of bounded faces)\n";
  text += fmt::format("matched one to one: {} vertices, {} edges, {} faces\n", c.matched_vertices,
                      c.matched_edges, c.matched_faces);
}

std::string plural(CellKind kind) {
  return kind == CellKind::Vertex ? "vertices" : to_text(kind) + 's';
}

/// "2 edges merged, 1 face missing", the most frequent first, some of them.
std::string kinds(const std::vector<const Finding*>& findings) {
  std::map<std::pair<CellKind, Disagreement>, std::size_t> counts;
  for (const Finding* finding : findings) ++counts[{finding->kind, finding->disagreement}];
  std::vector<std::pair<std::pair<CellKind, Disagreement>, std::size_t>> sorted(counts.begin(),
                                                                                counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(sorted.size(), kShownKinds); ++i) {
    const auto& [kind, count] = sorted[i];
    text +=
        fmt::format("{}{} {} {}", i == 0 ? "" : ", ", count,
                    count == 1 ? to_text(kind.first) : plural(kind.first), to_text(kind.second));
  }
  return sorted.size() > kShownKinds ? text + ", ..." : text;
}

/// What rounding alone would change.
void append_conversion(std::string& text, const Comparison& conversion) {
  if (conversion.agree()) return;
  std::vector<const Finding*> findings;
  for (const Finding& finding : conversion.findings) findings.push_back(&finding);
  text += fmt::format("rounding the input to doubles alone changes: {}\n", kinds(findings));
}

/// Where the stage stands: what happens before the engine, its stages, the engine as a whole.
std::size_t place_of(const std::string& stage, const Answer& answer) {
  if (stage == kDrawing) return 0;
  if (stage == kParse) return 1;
  if (stage == kTransform) return 2;
  const auto found = std::find(answer.stages.begin(), answer.stages.end(), stage);
  return 3 + static_cast<std::size_t>(found - answer.stages.begin());
}

/// One row per stage and rule, in their order.
void append_causes(std::string& text, const Check& check) {
  struct Row {
    std::string stage;
    std::vector<const Finding*> findings;
    std::size_t confirmed = 0;
  };
  std::map<std::tuple<std::size_t, std::size_t, std::string>, Row> rows;
  for (std::size_t i = 0; i < check.causes.size(); ++i) {
    const Cause& cause = check.causes[i];
    Row& row = rows[{place_of(cause.stage, check.answer), cause.round, cause.rule}];
    row.stage = cause.stage;
    row.findings.push_back(&check.comparison.findings[i]);
    if (cause.confirmed) ++row.confirmed;
  }
  if (rows.empty()) return;
  text += "\nwhere they come from\n";
  for (const auto& [place, row] : rows) {
    const auto& [order, round, rule] = place;
    text += fmt::format("  {}{}, {}: {} ({}{})\n", row.stage,
                        round == 0 ? "" : fmt::format(" in round {}", round), rule,
                        row.findings.size(), kinds(row.findings),
                        row.confirmed == row.findings.size()
                            ? ""
                            : fmt::format("; {} of them confirmed", row.confirmed));
  }
}

void append_input(std::string& text, const SegmentSet& input) {
  text += fmt::format("input: {} segments, {} points; {} rejected\n", input.segments.size(),
                      input.points.size(), input.rejected.size());
  const std::size_t shown = std::min(input.rejected.size(), kShownRejected);
  for (std::size_t i = 0; i < shown; ++i) {
    const Rejected& item = input.rejected[i];
    text += fmt::format("  rejected {}: {}\n", line_text(to_text(item.source, input.files)),
                        line_text(item.reason));
  }
  if (shown < input.rejected.size()) {
    text += fmt::format("  ... and {} more\n", input.rejected.size() - shown);
  }
}

/// "3 numbers were replaced: by at most 1e-15 rad (2), 0.001 (1)".
void append_ledger(std::string& text, const std::vector<Replacement>& ledger) {
  if (ledger.empty()) {
    text += "exactness: every coordinate is exactly what the file says\n";
    return;
  }
  std::vector<std::pair<std::string, std::size_t>> bounds;
  for (const Replacement& item : ledger) {
    const auto same = [&](const auto& entry) { return entry.first == item.bound; };
    const auto it = std::find_if(bounds.begin(), bounds.end(), same);
    if (it != bounds.end()) {
      ++it->second;
    } else {
      bounds.emplace_back(item.bound, 1);
    }
  }
  text += fmt::format("exactness: {} number{} replaced, by at most", ledger.size(),
                      ledger.size() == 1 ? " was" : "s were");
  const std::size_t shown = std::min(bounds.size(), kShownBounds);
  for (std::size_t i = 0; i < shown; ++i) {
    text +=
        fmt::format("{} {} ({})", i == 0 ? "" : ",", line_text(bounds[i].first), bounds[i].second);
  }
  if (shown < bounds.size()) text += fmt::format(" and {} more", bounds.size() - shown);
  text += '\n';
}

void append_finding(std::string& text, const Check& check, std::size_t i) {
  const Finding& finding = check.comparison.findings[i];
  text += fmt::format("{:>4}. {} {}", i + 1, to_text(finding.kind), to_text(finding.disagreement));
  if (finding.kind != CellKind::Complex) {
    const PointD place = nearest(finding.where);
    text += fmt::format(" at ({}, {})", short_number(place.x), short_number(place.y));
  }
  text += fmt::format(": {}\n", line_text(finding.message));
  if (i < check.causes.size()) {
    const Cause& cause = check.causes[i];
    text += fmt::format("      {}: {}", cause.stage, line_text(cause.explanation));
    if (!cause.advice.empty()) text += fmt::format("; {}", line_text(cause.advice));
    text += '\n';
  }
  text += input_lines(check.input, finding.segments, "      ");
}

}  // namespace

std::string to_text(const Check& check, std::size_t limit) {
  const Comparison& c = check.comparison;
  std::string text = verdict(check) + '\n';
  append_cell_counts(text, check);
  if (check.answer.radius) text += fmt::format("radius {}, ", short_number(*check.answer.radius));
  text += fmt::format("tolerance {}, largest displacement {}\n", short_number(c.tolerance),
                      short_number(c.largest_displacement));
  if (!c.float_valid) text += "the float result by itself is not a valid complex\n";
  append_input(text, check.input);
  append_ledger(text, check.input.ledger);
  if (check.drift.places > 0) text += to_text(check.drift) + '\n';
  append_conversion(text, check.conversion);
  if (c.agree()) return text + advice_text(check, kShownSteps);
  append_causes(text, check);
  text += '\n';
  const std::size_t shown = std::min(c.findings.size(), limit);
  for (std::size_t i = 0; i < shown; ++i) append_finding(text, check, i);
  if (shown < c.findings.size()) {
    text += fmt::format("... and {} more (see -o report.json)\n", c.findings.size() - shown);
  }
  return text + advice_text(check, kShownSteps);
}

}  // namespace plumbline
