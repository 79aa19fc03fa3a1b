#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "plumbline/complex.hpp"
#include "plumbline/published.hpp"

namespace plumbline {

/// The complex as JSON: vertices (exact text and nearest double), edges with their sources, faces
/// with cycles of signed edges, area, depth, interior point; components; rejected items; ledger;
/// signature. Documented in docs/json.md.
std::string to_json(const ExactComplex& complex, const SegmentSet& input);

/// The complex as an SVG picture, in the drawing's own coordinates: faces filled by nesting depth,
/// edges, antennas dashed. **Rounded** to nearest doubles.
std::string to_svg(const ExactComplex& complex);

/// The trace of the published LAR pipeline as JSON, with the keys that the original's recorded
/// outputs have. Documented in docs/json.md.
std::string to_json(const lar::published::Trace& trace);

/// Writes a file whole or not at all: to a temporary beside it, then renamed. Throws: Error
/// BadFile.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace plumbline
