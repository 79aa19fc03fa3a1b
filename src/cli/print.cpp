#include "cli/print.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::cli {

namespace {

/// The items by element and reason, with the first lines.
template <class Item>
std::string group_lines(const std::vector<Item>& items, std::string Item::*reason,
                        const char* word) {
  constexpr std::size_t kShownLines = 8;
  std::map<std::pair<std::string, std::string>, std::vector<std::uint32_t>> groups;
  for (const Item& item : items) {
    groups[{item.source.element, item.*reason}].push_back(item.source.line);
  }
  std::string text;
  for (const auto& [what, lines] : groups) {
    text += fmt::format("  {}{} x {}: {}; line", word, lines.size(), line_text(what.first),
                        line_text(what.second));
    for (std::size_t i = 0; i < std::min(lines.size(), kShownLines); ++i) {
      text += fmt::format(" {}", lines[i]);
    }
    text += lines.size() > kShownLines ? " ...\n" : "\n";
  }
  return text;
}

}  // namespace

std::string counts_line(const Counts& c) {
  return fmt::format(
      "{} vertices, {} edges ({} antennas), {} faces with {} holes, {} components, depth {}",
      c.vertices, c.edges, c.antennas, c.faces, c.holes, c.components, c.depth);
}

std::string input_line(const SegmentSet& input) {
  std::string text =
      fmt::format("{} segments, {} rejected", input.segments.size(), input.rejected.size());
  if (input.remarks.empty()) return text;
  return text +
         fmt::format(", {} remark{}", input.remarks.size(), input.remarks.size() == 1 ? "" : "s");
}

std::string rejected_lines(const SegmentSet& input) {
  std::string text = group_lines(input.rejected, &Rejected::reason, "");
  return text + group_lines(input.remarks, &Remark::what, "remark: ");
}

std::string exactness_line(const SegmentSet& input) {
  if (input.ledger.empty()) return "every coordinate is exactly what the file says";
  const Replacement& first = input.ledger.front();
  return fmt::format("{} numbers were replaced, the first: {} within {} ({})", input.ledger.size(),
                     line_text(first.what), first.bound,
                     line_text(to_text(first.source, input.files)));
}

void set_input(Report& report, const SegmentSet& input) {
  report.set("segments", input.segments.size());
  report.set("points", input.points.size());
  set_losses(report, input);
}

void set_losses(Report& report, const SegmentSet& input) {
  report.set("rejected", input.rejected.size());
  report.set("lost", count_lost(input.rejected));
  report.set("remarks", input.remarks.size());
  report.set("replaced_numbers", input.ledger.size());
}

void set_counts(Report& report, const Counts& counts) {
  report.set("vertices", counts.vertices);
  report.set("edges", counts.edges);
  report.set("antennas", counts.antennas);
  report.set("faces", counts.faces);
  report.set("holes", counts.holes);
  report.set("components", counts.components);
  report.set("depth", counts.depth);
}

}  // namespace plumbline::cli
