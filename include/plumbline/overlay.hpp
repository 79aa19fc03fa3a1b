#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/regions.hpp"

namespace plumbline {

/// Which pieces of two layers of polygons stay, in the words of GeoPandas and QGIS.
enum class OverlayHow {
  Intersection,         ///< in both
  Union,                ///< in either
  Difference,           ///< in the first alone
  SymmetricDifference,  ///< in one alone
  Identity,             ///< in the first, parted by the second
};
inline constexpr std::string_view kOverlayHows[] = {"intersection", "union", "difference",
                                                    "symmetric_difference", "identity"};
std::string to_text(OverlayHow how);
/// Throws: Error BadInput for a word that is none of kOverlayHows.
OverlayHow overlay_how(std::string_view word);

/// What lies in the same polygons of both layers: it may be of several parts.
struct Piece {
  std::vector<RegionId> first, second;  ///< the polygons that it lies in, of each layer, ascending
  std::vector<FaceId> faces;            ///< of Overlay::complex, ascending
  Rational area;                        ///< **exact**
};

/// Two layers of polygons laid over each other.
struct Overlay {
  SegmentSet input;             ///< both drawings, the second after the first
  std::vector<Region> regions;  ///< polygons, those of the second after those of the first
  std::size_t first_count = 0;  ///< how many are of the first
  /// Faces are parts of pieces, or lie in none; edges know all segments that they lie on.
  ExactComplex complex;
  std::vector<Piece> pieces;    ///< by their first face
  std::vector<SegmentId> open;  ///< those of no polygon, ascending

  Rational area() const;
};

/// Lays the polygons of one drawing over those of another. **Exact**: pieces cover what they
/// should, point by point, and areas add up to the last digit. Where polygons of one layer overlap,
/// a piece lies in all of them. Degenerate: what touches in lines or points has no piece. Open
/// rings, and lines that are no closed ones, are left out: see `open`. Cost: as `arrange`, and
/// O(k log k) for all that the pieces say. Throws: as `arrange`, `label`; Error BadInput where the
/// systems of coordinates are two.
Overlay overlay(SegmentSet first, const SegmentSet& second, OverlayHow how,
                FillRule rule = FillRule::EvenOdd, std::size_t threads = 0);

/// One drawing of two: segments, sources and rings of the second come after those of the first.
/// Throws: Error BadInput where both name systems of coordinates and they are not the same.
SegmentSet together(SegmentSet first, const SegmentSet& second);

}  // namespace plumbline
