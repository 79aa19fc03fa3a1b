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

/// The layers that a file declares, each with its colour and whether it is hidden.
inline std::string layers_of(const SegmentSet& set) {
  std::string text;
  for (const Layer& layer : set.layers) {
    std::string rgb = "-";
    if (layer.rgb) {
      rgb.clear();
      for (int shift = 20; shift >= 0; shift -= 4) {
        rgb += "0123456789abcdef"[*layer.rgb >> static_cast<unsigned>(shift) & 15U];
      }
    }
    text += layer.name + " " + rgb + (layer.hidden ? " hidden\n" : "\n");
  }
  return text;
}

/// The labels, each with its place and its source.
inline std::string labels_of(const SegmentSet& set) {
  std::string text;
  for (const Label& label : set.labels) {
    text += label.text + (label.place ? " at " + to_text(*label.place) : "") + " | " +
            to_text(set.sources.at(label.source), set.files) + "\n";
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
