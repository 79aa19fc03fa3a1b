#pragma once

#include <string>

#include "plumbline/structure.hpp"

namespace plumbline {

/// The segments of an evaluated structure, one a line.
inline std::string segments_of(const SegmentSet& set) {
  std::string text;
  for (const Segment& segment : set.segments) text += to_text(segment) + "\n";
  return text;
}

/// What was rejected, one item a line: its source, the reason and the offending text.
inline std::string rejected_of(const SegmentSet& set) {
  std::string text;
  for (const Rejected& item : set.rejected) {
    text += to_text(item.source, set.files) + ": " + item.reason;
    text += item.text.empty() ? "\n" : ": " + item.text + "\n";
  }
  return text;
}

/// Each segment with its source, then what was rejected, then the ledger.
inline std::string listing(const Structure& structure) {
  const SegmentSet set = evaluate(structure);
  std::string text;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Source& source = set.sources.at(set.segment_source.at(i));
    text += to_text(set.segments[i]) + " | " + to_text(source, set.files) + "\n";
  }
  const std::string rejected = rejected_of(set);
  if (!rejected.empty()) text += "rejected:\n" + rejected;
  for (const Replacement& entry : set.ledger) {
    text += "replaced: " + to_text(entry.source, set.files) + ": " + entry.what + " by " +
            entry.bound + "\n";
  }
  return text;
}

}  // namespace plumbline
