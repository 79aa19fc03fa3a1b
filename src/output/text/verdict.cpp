// What the reports have in common.

#include "output/text/verdict.hpp"

#include <fmt/format.h>

#include <unordered_set>

namespace plumbline {

std::string verdict(const Comparison& comparison) {
  const std::size_t count = comparison.findings.size();
  std::string text = count == 0 ? "agree" : fmt::format("disagree: {} finding", count);
  if (count > 1) text += 's';
  if (comparison.compared == Compared::Graph) text += " (vertices and edges alone: no faces)";
  return text;
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
