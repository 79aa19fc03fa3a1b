#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/regions.hpp"

/// Coverages: layers of polygons that should neither overlap nor leave gaps, as parcels, districts
/// and zones. Faces are given to other polygons, and that is all: **no vertex ever moves**.
namespace plumbline {

/// Polygons, and which of them lie where.
struct Coverage {
  std::vector<Region> polygons;
  /// Neighbours that lie in the same polygons are one face.
  ExactComplex complex;
  /// Per face the polygons that it lies in, ascending: none in a gap and outside, several where
  /// they overlap.
  Lists<RegionId> owners;
};
/// The polygons of a drawing as `regions` has them: each with its parts and holes; open rings, and
/// what has no length, are none. **Exact**. Requires: the complex is `arrange(input)`. Order: as in
/// the file. Cost: O(n log n), and what `owners` holds. Throws: as `label`.
Coverage coverage(const SegmentSet& input, const ExactComplex& complex,
                  FillRule rule = FillRule::EvenOdd);

/// Per polygon, **exact**.
std::vector<Rational> polygon_areas(const Coverage& coverage);

enum class CoverageFaultKind {
  Overlap,          ///< a face in several polygons
  Gap,              ///< a bounded face in none: polygons enclose it
  UnmatchedVertex,  ///< a corner of one polygon in the middle of a side of another one
};
/// "overlap", "gap", "unmatched vertex".
std::string to_text(CoverageFaultKind kind);

/// What is wrong in one place. A slit that is open to the outside is no gap; its vertices may be
/// unmatched.
struct CoverageFault {
  CoverageFaultKind kind = CoverageFaultKind::Overlap;
  /// Ascending: those that overlap; those around the gap; of an unmatched vertex first the one
  /// whose side has no vertex there, then those that have a corner there.
  std::vector<RegionId> polygons;
  Point at;           ///< **exact**: inside the face; the vertex
  FaceId face;        ///< of Coverage::complex; none for a vertex
  Rational area = 0;  ///< **exact**
  /// Diameter of the largest circle in the face. **Rounded**: within some percent; where the face
  /// is a thousand times as long as wide, 2 area / perimeter at least, which is half of it or more.
  double width = 0;
};

/// Up to which size gaps or overlaps count; what is larger is as it is meant to be, as a lake is.
struct SizeLimit {
  std::optional<Rational> width, area;
};

/// All faults: overlaps and gaps by face, then vertices from left to right. Requires: the coverage
/// is that of `input`. Cost: O(n log n), and the widths, some 10 ms each where they are no
/// triangles and narrow.
std::vector<CoverageFault> faults(const Coverage& coverage, const SegmentSet& input);

/// To which polygon a face goes. Of several that are as good the first one in the drawing has it.
enum class CoveragePolicy {
  LongestBorder,  ///< with which it has the longest border; of several the largest
  Largest,        ///< of the largest area, as it was drawn
  Smallest,       ///< of the smallest
  First,          ///< that comes first in the drawing
};
inline constexpr std::string_view kCoveragePolicies[] = {"longest-border", "largest", "smallest",
                                                         "first"};
std::string to_text(CoveragePolicy policy);
/// Throws: Error BadInput for a word that is none of kCoveragePolicies.
CoveragePolicy coverage_policy(std::string_view word);

struct CleanOptions {
  CoveragePolicy policy = CoveragePolicy::LongestBorder;
  SizeLimit gaps, overlaps;
};
/// Whether a gap or an overlap is within its limit; vertices always are.
bool is_within(const CoverageFault& fault, const CleanOptions& options);

/// A face that is in one polygon now.
struct Reassigned {
  CoverageFault fault;  ///< as it was; its face is one of the coverage before
  RegionId to;
};

/// A coverage whose gaps and overlaps, as far as they are within the limits, each belong to one
/// polygon.
struct CleanCoverage {
  /// Sides that neighbours share have the same vertices. A vertex that is no corner of a polygon
  /// beside it is left out where the side is straight.
  Coverage coverage;
  std::vector<Reassigned> changes;  ///< overlaps, then gaps, by face
  std::vector<RegionId> vanished;   ///< polygons of which nothing is left, ascending
};
/// Gives each overlap to one of its polygons, then each gap to one beside it. The border with a
/// polygon are the sides across which it lies; lengths are **rounded**, the same where they differ
/// by 1e-12 of theirs; everything else is **exact**. What the polygons cover is what they covered,
/// and the gaps that were filled. Requires: the coverage and the faults are those of `input`. Cost:
/// O(n log n).
CleanCoverage cleaned(const Coverage& coverage, const SegmentSet& input,
                      const std::vector<CoverageFault>& faults, const CleanOptions& options = {});

/// Per polygon its parts, which are valid together and whose rings are made of all vertices on
/// them. Vertices and faces are those of the complex, which is that of a coverage or a rounding of
/// it; `owners` per face of it, as of Coverage. **Exact**. Cost: O(n log n), and O(n log n) for
/// each polygon that overlaps another one.
std::vector<std::vector<FacePolygon>> owned_polygons(const ExactComplex& complex,
                                                     const Lists<RegionId>& owners,
                                                     std::size_t polygon_count);

}  // namespace plumbline
