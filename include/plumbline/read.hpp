#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "plumbline/structure.hpp"

namespace plumbline {

/// The drawing in a file, every number exact. The format is told by the file name's ending: `.svg`,
/// `.lines`. What the reader does not understand is listed in `rejected`, with its place.
/// Throws: Error BadFile, BadInput (malformed file, unknown ending), Limit.
Structure read(const std::filesystem::path& file);

/// SVG text as a Structure: `g` and nested `svg` become Structs named by their id (or tag), their
/// transforms Affines; `line`, `rect`, `polyline`, `polygon` and `path` with the commands M L H V Z
/// become Models. Coordinates are user units of the root's viewBox, y downwards, as in the file.
/// `rejected` lists every element that is not understood, by name and line.
Structure read_svg(std::string_view text, const std::string& file_name);

/// LAR's `.lines` text: a row `x1,y1,x2,y2` per segment; empty rows are skipped. A row that is
/// anything else is `rejected`.
Structure read_lines(std::string_view text, const std::string& file_name);

}  // namespace plumbline
