#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

/// Test cases of other geometry libraries as line work, and what their files say of them.
namespace plumbline::foreign {

/// What a file says of a geometry that it gives as well-known text.
struct Claim {
  enum class Kind { Valid, Simple };
  Kind kind;
  std::string wkt;
  bool holds;
};

/// The area that a boolean operation on closed paths has by a file, which gives it or the result.
struct AreaClaim {
  enum class Rule { EvenOdd, NonZero, Positive, Negative };
  enum class Operation { Intersection, Union, Difference, ReverseDifference, Xor };
  Rule rule;
  Operation operation;
  /// Of the case's segments, those before it are the subject's, those from here on the clip's.
  std::size_t first_clip;
  Rational area;
  double rounding;   ///< how far the corners of that result may be from where they belong
  double perimeter;  ///< of that result, if it is given; else 0
};

struct Case {
  std::string name;
  SegmentSet input;  ///< with what could not be drawn in `rejected`
  std::vector<Claim> claims;
  std::vector<AreaClaim> areas;
  std::vector<std::string> unexamined;  ///< operations whose outcomes are not looked at
};

/// JTS and GEOS test files: per `case` the geometries a and b, as well-known text or hexadecimal
/// well-known binary, and the operations isValid and isSimple on one of them. A geometry that
/// cannot be read is in `rejected`, as its reader's error says. This and the others throw: Error
/// BadInput for what is not the format.
std::vector<Case> jts_xml(std::string_view text);
/// Clipper2's text: per CAPTION closed paths of subjects and clips, open paths, and an area where
/// no path is open.
std::vector<Case> clipper2(std::string_view text);
/// CDT's text: "n m", then n points, which are isolated points of the case, and m pairs of indices.
std::vector<Case> cdt(std::string_view text);
/// poly2tri's: a point per row, all of them one closed path.
std::vector<Case> poly2tri(std::string_view text);
/// iOverlay's JSON: closed paths (subjPaths, clipPaths, body) and open ones (string); its results
/// are not used.
std::vector<Case> ioverlay(std::string_view text);

/// The cases of a file, by its name: `.xml`, `.cdt.txt`, `.dat`, `.json`, other `.txt` (Clipper2),
/// and what the project's reader takes. Throws: as those; Error BadInput for another name.
std::vector<Case> read_file(const std::filesystem::path& file);

}  // namespace plumbline::foreign
