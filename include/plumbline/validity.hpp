#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/regions.hpp"
#include "plumbline/rings.hpp"

/// Whether polygons are valid (OGC SFA 1.2.1), why not, and valid ones in their place.
namespace plumbline {

/// A polygon, or a closed line that is part of none, with all that is wrong with it.
struct PolygonValidity {
  std::size_t first_ring = 0, last_ring = 0;  ///< indices into SegmentSet::rings, both its own
  std::vector<RingProblem> problems;          ///< as `ring_problems`; none: it is valid

  bool is_valid() const { return problems.empty(); }
};
/// One for each polygon of the drawing, in its order; those of which nothing was left are none.
/// **Exact**. Requires and cost: as `ring_problems`.
std::vector<PolygonValidity> validity(const SegmentSet& input, const ExactComplex& complex);

/// The segment that tells where a polygon comes from. Requires: one of `validity`.
SegmentId first_segment(const SegmentSet& input, const PolygonValidity& polygon);

/// What an invalid polygon covers.
enum class ValidMeaning {
  Linework,   ///< what a line to the outside meets an odd number of rings from: evenodd
  Structure,  ///< its parts, of each what its outer ring goes around without what its holes do
  NonZero,    ///< what all rings, as they run, go around more often one way than the other
};
inline constexpr std::string_view kValidMeanings[] = {"linework", "structure", "nonzero"};
/// Throws: Error BadInput for a word that is none of kValidMeanings.
ValidMeaning valid_meaning(std::string_view word);

/// The polygon as valid ones, which are one multipolygon. **Exact**: rings keep their corners and
/// get one where they cross. Degenerate: rings that are open are closed by a straight line; of what
/// has no area nothing is left. Requires: one of `validity`. Cost: as `arrange` of its rings.
RegionPolygons made_valid(const SegmentSet& input, const PolygonValidity& polygon,
                          ValidMeaning meaning);

}  // namespace plumbline
