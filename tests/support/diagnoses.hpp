#pragma once

#include <string>

#include "plumbline/arrange.hpp"
#include "plumbline/diagnose.hpp"
#include "segments.hpp"

// Diagnoses as the tests of several kinds of defects look at them.
namespace plumbline {

inline Diagnosis diagnosis(const SegmentSet& set, const std::string& within,
                           std::size_t most_listed = 1000) {
  return diagnose(set, arrange(set), {parse_decimal(within), most_listed});
}

/// One defect a line: kind, place, square of the size (or area), tolerance, lines of the segments.
inline std::string list(const Diagnosis& diagnosis) {
  std::string text;
  for (const Defect& defect : diagnosis.defects) {
    text += to_text(defect.kind) + " at " + to_text(defect.where);
    if (defect.squared_size) text += " squared " + exact_text(*defect.squared_size);
    if (defect.area) text += " area " + exact_text(*defect.area);
    if (!defect.squared_size) text += " size " + shortest_text(defect.size);
    if (defect.proposed_tolerance) {
      text += " tolerance " + shortest_text(*defect.proposed_tolerance);
    }
    text += " of";
    for (const SegmentId s : defect.segments) text += ' ' + std::to_string(s + 1);
    text += '\n';
  }
  return text;
}
inline std::string list(const std::string& drawing, const std::string& within) {
  return list(diagnosis(segments(drawing), within));
}

inline const std::string kRoom = rectangle(0, 0, 10, 10);  // segments 1 to 4

}  // namespace plumbline
