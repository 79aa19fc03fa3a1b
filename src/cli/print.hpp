#pragma once

#include <string>

#include "cli/report.hpp"
#include "plumbline/plumbline.hpp"

namespace plumbline::cli {

/// "12 vertices, 13 edges (0 antennas), ...": one line on the complex.
std::string counts_line(const Counts& counts);
/// "12 segments, 3 rejected, 1 remark".
std::string input_line(const SegmentSet& input);
/// What was refused and remarked, grouped by element and reason, with the first lines; "" if
/// nothing was.
std::string rejected_lines(const SegmentSet& input);
/// The layers of a drawing that have lines or texts: those with most lines first.
struct LayerCount {
  std::string name;
  std::size_t segments = 0, texts = 0;
};
std::vector<LayerCount> layers_of(const SegmentSet& input);
/// Whether every coordinate is what the file says, or what was replaced.
std::string exactness_line(const SegmentSet& input);

/// The same numbers as members of the summary: of the input all, or what was lost or changed.
void set_input(Report& report, const SegmentSet& input);
void set_losses(Report& report, const SegmentSet& input);
void set_counts(Report& report, const Counts& counts);

}  // namespace plumbline::cli
