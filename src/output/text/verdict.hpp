#pragma once

#include <string>
#include <vector>

#include "plumbline/output.hpp"

namespace plumbline {

/// "agree", "disagree: 3 findings, 1 of them the file's own drift", or, where all are, "agree but
/// for the file's own drift: 3 findings"; also where only the graph is compared.
std::string verdict(const Check& check);

/// "radius 0.5 (larlib: 0.001 on the unit square)". Requires: an answer with a radius.
std::string radius_text(const Answer& answer);

/// A row of the table of counts.
struct CountRow {
  const char* name;
  std::size_t Counts::*member;
};
/// The rows in the order of every report.
const std::vector<CountRow>& count_rows();

/// The sources of the segments, each once, in the order of the segments.
std::vector<SourceId> sources_of(const SegmentSet& input, const std::vector<SegmentId>& segments);

}  // namespace plumbline
