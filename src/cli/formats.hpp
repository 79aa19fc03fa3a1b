#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::cli {

/// A format of output files.
struct Format {
  std::string_view name;                  ///< as --format has it
  std::vector<std::string_view> endings;  ///< of file names, in lower case; the usual one first
  bool of_complexes = false;              ///< whether arrange writes it
  bool of_features = false;               ///< whether it is made of `Features`, as `rooms` has them
};

/// All formats, one of each name.
const std::vector<Format>& formats();
/// The names of those that hold features, or whole complexes (features among them).
std::vector<std::string_view> feature_formats();
std::vector<std::string_view> complex_formats();
/// Those of findings and defects; json is GeoJSON, too.
std::vector<std::string_view> finding_formats();
/// Those of rooms: geojson by default.
std::vector<std::string_view> rooms_formats();
/// Those of repaired drawings: lines by default.
std::vector<std::string_view> repair_formats();
/// The format of that name. Requires: there is one.
const Format& format_named(std::string_view name);

/// The one of these formats that has the file's ending, in either case; the longest ending decides.
std::optional<std::string_view> format_by_ending(std::string_view file,
                                                 const std::vector<std::string_view>& names);
/// "json, svg or wkt"; of the endings ".json, .svg or .wkt".
std::string listed(const std::vector<std::string_view>& names);
std::string listed_endings(const std::vector<std::string_view>& names);

}  // namespace plumbline::cli
