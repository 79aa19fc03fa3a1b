#pragma once

#include <optional>
#include <string>

#include "plumbline/check.hpp"
#include "plumbline/diagnose.hpp"

namespace plumbline {

/// The verdict for a terminal: counts side by side, then the findings, numbered; `limit` of them.
std::string to_text(const Check& check, std::size_t limit = 4);
/// The same as JSON, all findings. Documented in docs/json.md.
std::string to_json(const Check& check);
/// Two panels of the same drawing, exact and float: faces filled by depth, edges, and every finding
/// marked with its number in a second colour.
std::string to_svg(const Check& check);
/// A page to look at all of it with a browser: pan and zoom, layers, findings, faces, the ladder.
/// One file that loads nothing else. Cost: some 20 bytes an edge and complex.
std::string to_html(const Check& check);
/// The findings of the float result as a GeoJSON layer for QGIS and OGR: a Feature per finding, its
/// place as a Point (null for kind Complex) in the drawing's own coordinates. Documented in
/// docs/json.md.
std::string to_geojson(const Check& check);

/// A tolerance ladder for a terminal: a table of its first `limit` steps. Requires: the ladder of
/// this complex.
std::string to_text(const ToleranceLadder& ladder, const ExactComplex& complex,
                    std::size_t limit = 20);
/// The same as a picture: vertices, edges and faces over the logarithm of the radius; radii for
/// which the float result is right in green.
std::string to_svg(const ToleranceLadder& ladder, const std::optional<RightRadii>& radii = {});

/// The diagnosis for a terminal: how many defects of each kind, then `limit` of each with their
/// places and elements, then what tolerances would mend. Numbers are positions in
/// Diagnosis::defects, from 1, here and below.
std::string to_text(const Diagnosis& diagnosis, const SegmentSet& input, std::size_t limit = 20);
/// The same as JSON, all that are listed. Documented in docs/json.md.
std::string to_json(const Diagnosis& diagnosis, const SegmentSet& input);
/// A panel for each kind that was found: the drawing with the defects marked by their numbers.
std::string to_svg(const Diagnosis& diagnosis, const SegmentSet& input,
                   const ExactComplex& complex);

}  // namespace plumbline
