#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/coverage.hpp"
#include "plumbline/validity.hpp"

namespace plumbline {

/// What is wrong with a coverage, for a terminal: how many overlaps, gaps and unmatched vertices,
/// how large, and of each kind the largest, `listed` or as many as fit on a screen. Faults beyond
/// the limits are counted apart.
std::string to_text(const Coverage& coverage, const std::vector<CoverageFault>& faults,
                    const CleanOptions& options, const SegmentSet& input,
                    std::optional<std::size_t> listed = {});

/// What was done to make it a clean one: which faces went to which polygon, the largest first, and
/// which polygons nothing is left of.
std::string to_text(const CleanCoverage& clean, const std::vector<CoverageFault>& faults,
                    const SegmentSet& input, std::optional<std::size_t> listed = {});

/// Which polygons are not valid: how many for which reason, in the words of JTS and GEOS; then, in
/// order, why and where, of `listed` polygons or as many as fit on a screen.
std::string to_text(const std::vector<PolygonValidity>& polygons, const SegmentSet& input,
                    std::optional<std::size_t> listed = {});

}  // namespace plumbline
