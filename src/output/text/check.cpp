// The report for a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "output/text/groups.hpp"
#include "output/text/ladder.hpp"
#include "output/text/terminal.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownReasons = 2;
constexpr std::size_t kShownBounds = 4;
constexpr std::size_t kShownCauses = 4;
constexpr std::size_t kScreen = 40;        // lines
constexpr std::size_t kShownOfGroup = 20;  // findings

void append_cell_counts(std::string& text, const Check& check) {
  const Comparison& c = check.comparison;
  text += fmt::format("\n{:<18}{:>13}{:>14}{:>12}\n", "", "as authored", "over doubles",
                      check.answer.short_title);
  for (const CountRow& row : count_rows()) {
    std::string name = row.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    const bool is_always_told = name == "vertices" || name == "edges" || name == "faces";
    const std::size_t authored = c.exact_counts.*row.member;
    const bool is_same = authored == check.conversion.float_counts.*row.member &&
                         authored == c.float_counts.*row.member;
    if (is_same && !is_always_told) continue;
    const bool is_of_graph = name == "vertices" || name == "edges" || name == "components";
    const bool is_known =
        c.compared != Compared::Nothing && (c.compared != Compared::Graph || is_of_graph);
    text += fmt::format("{:<18}{:>13}{:>14}{:>12}\n", name, c.exact_counts.*row.member,
                        check.conversion.float_counts.*row.member,
                        is_known ? std::to_string(c.float_counts.*row.member) : "-");
  }
  if (c.compared == Compared::SomeFaces || c.compared == Compared::Nothing) return;
  text += fmt::format("matched one to one: {} vertices, {} edges, {} faces\n", c.matched_vertices,
                      c.matched_edges, c.matched_faces);
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

struct CauseRow {
  std::string stage;
  std::vector<const Finding*> findings;
  std::size_t confirmed = 0;
};

/// One row per stage and rule, in their order, of the most frequent.
void append_causes(std::string& text, const Check& check) {
  std::map<std::tuple<std::size_t, std::size_t, std::string>, CauseRow> rows;
  for (std::size_t i = 0; i < check.causes.size(); ++i) {
    const Cause& cause = check.causes[i];
    CauseRow& row = rows[{place_of(cause.stage, check.answer), cause.round, cause.rule}];
    row.stage = cause.stage;
    row.findings.push_back(&check.comparison.findings[i]);
    if (cause.confirmed) ++row.confirmed;
  }
  if (rows.empty()) return;
  std::vector<std::size_t> sizes;
  for (const auto& entry : rows) sizes.push_back(entry.second.findings.size());
  std::sort(sizes.rbegin(), sizes.rend());
  const std::size_t least = sizes[std::min(sizes.size(), kShownCauses) - 1];
  text += "\nwhere they come from\n";
  std::size_t left_out = 0, shown = 0;
  for (const auto& [place, row] : rows) {
    if (row.findings.size() < least || shown == kShownCauses) {
      left_out += row.findings.size();
      continue;
    }
    ++shown;
    const auto& [order, round, rule] = place;
    text += fmt::format("  {}{}, {}: {} ({}{})\n", row.stage,
                        round == 0 ? "" : fmt::format(" in round {}", round), rule,
                        row.findings.size(), kinds(row.findings),
                        row.confirmed == row.findings.size()
                            ? ""
                            : fmt::format("; {} of them confirmed", row.confirmed));
  }
  if (left_out > 0) {
    text += fmt::format("  {} more of {} other kinds\n", left_out, rows.size() - shown);
  }
}

/// ": zero width (3), no such file (2)", the most frequent reasons.
template <class Item>
std::string reasons_text(const std::vector<Item>& items, std::string Item::*reason) {
  std::map<std::string, std::size_t> counts;
  for (const Item& item : items) ++counts[item.*reason];
  std::vector<std::pair<std::string, std::size_t>> reasons(counts.begin(), counts.end());
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  const std::size_t shown = std::min(reasons.size(), kShownReasons);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("{}{} ({})", i == 0 ? ": " : ", ", line_text(reasons[i].first),
                        reasons[i].second);
  }
  return shown < reasons.size() ? text + ", ..." : text;
}

void append_input(std::string& text, const SegmentSet& input) {
  text += fmt::format("input: {} segments, {} points; {} rejected{}\n", input.segments.size(),
                      input.points.size(), input.rejected.size(),
                      reasons_text(input.rejected, &Rejected::reason));
  if (const std::string stray = stray_text(input); !stray.empty()) text += "       " + stray + "\n";
  if (input.remarks.empty()) return;
  text += fmt::format("       {} remarked on{}\n", input.remarks.size(),
                      reasons_text(input.remarks, &Remark::what));
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

void append_finding(std::string& text, const Check& check, std::size_t number) {
  const Finding& finding = check.comparison.findings[number - 1];
  text += fmt::format("      finding {}: {} {}", number, to_text(finding.kind),
                      to_text(finding.disagreement));
  if (finding.kind != CellKind::Complex) {
    text += " at " + place_text(finding.where, check.comparison.tolerance);
  }
  text += fmt::format(": {}\n", line_text(finding.message));
  if (number <= check.causes.size()) {
    const Cause& cause = check.causes[number - 1];
    text += fmt::format("        {}: {}", cause.stage, line_text(cause.explanation));
    if (!cause.advice.empty()) text += fmt::format("; {}", line_text(cause.advice));
    text += '\n';
    for (const Cause& other : cause.with) {
      text += fmt::format("      with {}: {}\n", other.stage, line_text(other.explanation));
    }
  }
  text += input_lines(check.input, finding.segments, "        ");
}

std::string findings_of(const FindingGroup& group, const Check& check) {
  std::string text;
  const std::size_t shown = std::min(group.findings.size(), kShownOfGroup);
  for (std::size_t i = 0; i < shown; ++i) append_finding(text, check, group.findings[i]);
  if (shown < group.findings.size()) {
    text += fmt::format("      ... and {} more findings\n", group.findings.size() - shown);
  }
  return text;
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The groups, as many as are asked for, with their findings; by default without, as many as fit
/// on a screen below the text.
void append_groups(std::string& text, const Check& check, std::optional<std::size_t> listed) {
  const std::vector<FindingGroup>& groups = check.groups;
  std::string rows = groups.size() == 1 ? "\n" : "\nwhat changes most comes first\n";
  std::size_t shown = 0;
  for (; shown < std::min(groups.size(), listed.value_or(groups.size())); ++shown) {
    std::string row = group_lines(groups[shown], shown + 1, check);
    if (listed) row += findings_of(groups[shown], check);
    if (!listed && shown > 0 && line_count(text) + line_count(rows + row) >= kScreen) break;
    rows += row;
  }
  if (shown < groups.size()) {
    rows +=
        fmt::format("{} more groups (--list {} prints more, with findings; --report page.html)\n",
                    groups.size() - shown, std::min<std::size_t>(groups.size(), 100));
  }
  text += rows;
}

/// What to do, where the engine merges within a radius.
void append_radius_advice(std::string& text, const Check& check) {
  if (check.crowded_vertices > 0) {
    text += fmt::format(
        "The radius {} is larger than details of the drawing: {} of its {} "
        "vertices are nearer to another one.\n",
        short_number(*check.answer.radius), check.crowded_vertices,
        check.comparison.exact_counts.vertices);
  }
  if (!check.right_radii) return;
  text += right_radii_text(*check.right_radii, check.answer.short_title);
  if (!check.right_radii->empty() && check.drift.places > 0) {
    text += "Right but for the file's own drift, which no radius changes.\n";
  }
}

}  // namespace

std::string to_text(const Check& check, std::optional<std::size_t> listed) {
  const Comparison& c = check.comparison;
  std::string text = verdict(check) + '\n';
  append_radius_advice(text, check);
  if (!c.float_valid) text += "the float result by itself is not a valid complex\n";
  append_cell_counts(text, check);
  if (c.compared != Compared::Nothing) {
    if (check.answer.radius) text += radius_text(check.answer) + ", ";
    text += fmt::format("tolerance {}, largest displacement {}\n", short_number(c.tolerance),
                        short_number(c.largest_displacement));
  }
  append_input(text, check.input);
  append_ledger(text, check.input.ledger);
  if (check.drift.places > 0) text += to_text(check.drift) + '\n';
  append_conversion(text, check.conversion);
  if (c.agree()) return text;
  append_causes(text, check);
  append_groups(text, check, listed);
  return text;
}

}  // namespace plumbline
