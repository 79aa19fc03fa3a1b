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

/// What was remarked, in the same way.
inline std::string remarks_of(const SegmentSet& set) {
  std::string text;
  for (const Remark& item : set.remarks) {
    text += to_text(item.source, set.files) + ": " + item.what;
    text += item.text.empty() ? "\n" : ": " + item.text + "\n";
  }
  return text;
}

/// Of what was rejected the elements that looked like geometry: "MLINE RAY ".
inline std::string lost_of(const SegmentSet& set) {
  std::string text;
  for (const Rejected& item : set.rejected) {
    if (!item.harmless) text += item.source.element + " ";
  }
  return text;
}

/// Each segment with its source, then what was rejected, the remarks, the ledger.
inline std::string listing(const Structure& structure) {
  const SegmentSet set = evaluate(structure);
  std::string text;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Source& source = set.sources.at(set.segment_source.at(i));
    text += to_text(set.segments[i]) + " | " + to_text(source, set.files) + "\n";
  }
  const std::string rejected = rejected_of(set);
  if (!rejected.empty()) text += "rejected:\n" + rejected;
  const std::string remarks = remarks_of(set);
  if (!remarks.empty()) text += "remarks:\n" + remarks;
  for (const Replacement& entry : set.ledger) {
    text += "replaced: " + to_text(entry.source, set.files) + ": " + entry.what + " by " +
            entry.bound + "\n";
  }
  return text;
}

}  // namespace plumbline
