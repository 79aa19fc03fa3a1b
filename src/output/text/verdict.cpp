// What the reports have in common.

#include "output/text/verdict.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "output/text/terminal.hpp"

namespace plumbline {

namespace {

/// What of the drawing the answer says nothing of, and was not compared.
std::string claims_text(const Comparison& c) {
  if (c.compared == Compared::Graph) return " (vertices and edges alone: no faces)";
  if (c.compared == Compared::SomeFaces) {
    return fmt::format(
        " ({} of the result's faces are faces of the drawing; nothing else is compared)",
        c.matched_faces);
  }
  if (c.compared == Compared::All || c.edges_left_out + c.vertices_left_out == 0) return {};
  return fmt::format(
      " (the result has polygons alone: {} edge{} with the same face on both sides, dangling ones "
      "or bridges, {} not compared)",
      c.edges_left_out, c.edges_left_out == 1 ? "" : "s", c.edges_left_out == 1 ? "is" : "are");
}

}  // namespace

std::string verdict(const Check& check) {
  const std::size_t count = check.comparison.findings.size(), own = check.own_findings();
  const std::size_t groups = check.groups.size();
  std::string findings = fmt::format("{} finding{}", count, count == 1 ? "" : "s");
  if (count > 1) findings += fmt::format(" in {} group{}", groups, groups == 1 ? "" : "s");
  const bool is_empty = check.input.segments.empty() && check.input.points.empty();
  std::string text = is_empty ? "nothing was drawn, so there is nothing to agree about" : "agree";
  if (count > 0 && own == count) {
    text = "agree but for the file's own drift: " + findings;
  } else if (count > 0) {
    text = "disagree: " + findings;
    if (own > 0) text += fmt::format(", {} of them the file's own drift", own);
  }
  if (check.comparison.compared == Compared::Nothing && count > 0) {
    text = "disagree: no result, " + line_text(check.comparison.findings.front().message);
  }
  text += claims_text(check.comparison);
  const std::size_t lost = count_lost(check.input.rejected);
  if (lost > 0) text += fmt::format("; not all was read: {} rejected look like geometry", lost);
  return text;
}

std::string radius_text(const Answer& answer) {
  const std::string radius = "radius " + short_number(*answer.radius);
  const std::string& from = answer.radius_from;
  if (from == "larlib") return radius + " (larlib: 0.001 on the unit square)";
  if (from == "plasm") return radius + " (plasm: 1e-8)";
  if (from == "segment") return radius + " (a quarter of the shortest segment)";
  return from == "drawing" ? radius + " (the engine's default)" : radius;
}

const std::vector<CountRow>& count_rows() {
  static const std::vector<CountRow> rows = {{"vertices", &Counts::vertices},
                                             {"edges", &Counts::edges},
                                             {"faces", &Counts::faces},
                                             {"holes", &Counts::holes},
                                             {"isolated_vertices", &Counts::isolated_vertices},
                                             {"components", &Counts::components},
                                             {"antennas", &Counts::antennas},
                                             {"depth", &Counts::depth}};
  return rows;
}

std::vector<SourceId> sources_of(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  std::vector<SourceId> result;
  std::unordered_set<std::size_t> seen;
  for (const SegmentId s : segments) {
    if (s >= input.segment_source.size()) continue;
    const SourceId source = input.segment_source[s];
    if (seen.insert(source).second) result.push_back(source);
  }
  return result;
}

}  // namespace plumbline
