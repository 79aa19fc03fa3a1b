#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "plumbline/structure.hpp"

namespace plumbline {

/// Largest file that `read` takes, in bytes.
inline constexpr std::uintmax_t kMaxFileSize = std::uintmax_t{1} << 30U;

/// How a drawing is read where the file leaves a choice.
struct ReadOptions {
  /// Largest distance of a curve from the chords that replace it, in the units of the curve's own
  /// coordinates; 0 stands for a thousandth of the longer side of the curve's bounding box.
  Rational chord_tolerance = 0;
  /// Bound on the deviation of angles whose sine and cosine are not rational, in radians.
  double angle_bound = kAngleBound;
  /// Whether elements that the drawing hides are `rejected`; else they are drawn.
  bool visible_only = false;
};

/// The drawing in a file, every number exact. The format is told by the file name's ending, in
/// either case: `.svg`, `.lines`. What the reader does not understand is listed in `rejected`, with
/// its place. Throws: Error BadFile, BadInput (malformed file, unknown ending), Limit (beyond
/// kMaxFileSize; numbers or entities that grow beyond all measure).
Structure read(const std::filesystem::path& file, const ReadOptions& options = {});

/// SVG text as a Structure: `g`, `a` and nested `svg` become Structs named by their inkscape:label
/// or id, their transforms Affines; `line`, `rect`, `polyline`, `polygon` and `path` with the
/// commands M L H V Z become Models. Coordinates are user units of the root's viewBox, y downwards,
/// as in the file. `rejected` lists by name and line every element that is not understood or not
/// drawn in its place, every curved piece of a path, and what follows an error in path data.
/// Neither interpreted nor listed: visibility, clipping, markers, style sheets, animation. Columns
/// count bytes of UTF-8. No recursion: depth is limited by memory only. Throws: Error BadInput for
/// malformed XML and a root other than `svg`; Limit.
Structure read_svg(std::string_view text, const std::string& file_name,
                   const ReadOptions& options = {});

/// LAR's `.lines` text: a row `x1,y1,x2,y2` per segment, blanks around the numbers allowed; empty
/// rows are skipped. A row that is anything else is `rejected`. Throws: Error Limit.
Structure read_lines(std::string_view text, const std::string& file_name);

}  // namespace plumbline
