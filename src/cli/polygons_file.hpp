#pragma once

#include <vector>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/report.hpp"

namespace plumbline::cli {

/// Writes the polygons of a drawing as they are now: into its own text where both are GeoJSON, else
/// as features. `note` is what is to be known of the numbers.
void write_polygons(const Output& output, const DrawingArguments& arguments, const Drawing& drawing,
                    const std::vector<DrawnPolygon>& polygons, const std::string& note,
                    Report& report);

/// Throws: Error BadInput for a drawing without polygons and closed lines.
void ensure_some(std::size_t polygons, const std::string& file);

}  // namespace plumbline::cli
