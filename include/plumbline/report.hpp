#pragma once

#include <string>

#include "plumbline/crosscheck.hpp"
#include "plumbline/lar.hpp"

namespace plumbline {

/// Everything a report speaks of.
struct CheckedDrawing {
  const SegmentSet& input;
  const ExactComplex& exact_complex;
  const FloatComplex& float_complex;
  double radius;
  const Crosscheck& crosscheck;
};

/// The verdict for a terminal: counts side by side, then the findings, numbered; `limit` of them.
std::string report_text(const CheckedDrawing& checked, std::size_t limit = 20);
/// The same as JSON, all findings. Documented in docs/json.md.
std::string report_json(const CheckedDrawing& checked);
/// Two panels of the same drawing, exact and float: faces filled by depth, edges, and every finding
/// marked with its number in a second colour.
std::string report_svg(const CheckedDrawing& checked);

}  // namespace plumbline
