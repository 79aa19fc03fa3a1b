#include "cli/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

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
  const auto add = [&text](std::size_t count, const char* thing) {
    if (count > 0) text += fmt::format(", {} {}{}", count, thing, count == 1 ? "" : "s");
  };
  add(input.remarks.size(), "remark");
  add(static_cast<std::size_t>(
          std::count_if(input.labels.begin(), input.labels.end(),
                        [](const Label& label) { return label.place.has_value(); })),
      "text");
  return text;
}

std::vector<LayerCount> layers_of(const SegmentSet& input) {
  std::vector<std::size_t> segments(input.sources.size()), texts(input.sources.size());
  for (const SourceId source : input.segment_source) ++segments[source];
  for (const Label& label : input.labels) ++texts[label.source];
  std::map<std::string, LayerCount> layers;
  for (std::size_t s = 0; s < input.sources.size(); ++s) {
    if (segments[s] + texts[s] == 0) continue;
    const std::string name = input.sources[s].layer;
    if (name.empty()) continue;
    LayerCount& layer = layers[name];
    layer.name = name;
    layer.segments += segments[s];
    layer.texts += texts[s];
  }
  std::vector<LayerCount> result;
  for (auto& [name, layer] : layers) result.push_back(std::move(layer));
  std::ranges::stable_sort(result, std::greater(), &LayerCount::segments);
  return result;
}

std::string rejected_lines(const SegmentSet& input) {
  const std::string stray = stray_text(input);
  std::string text = stray.empty() ? stray : "  " + stray + "\n";
  text += group_lines(input.rejected, &Rejected::reason, "");
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
