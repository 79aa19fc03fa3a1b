#pragma once

#include <span>
#include <vector>

#include "plumbline/coverage.hpp"

namespace plumbline::coverage_steps {

/// The coverage with neighbours joined that have the same owners.
Coverage by_owners(const ExactComplex& complex, const Lists<RegionId>& owners,
                   std::vector<Region> polygons);

/// Per face its edges, ascending.
Lists<EdgeId> edges_of_faces(const Incidences& complex);
/// The face on the other side of an edge of `face`.
FaceId across(const Incidences& complex, EdgeId e, FaceId face);

/// The width of a face, as CoverageFault has it.
double width(const ExactComplex& complex, FaceId face, std::span<const EdgeId> edges,
             const Rational& area);
/// **Rounded**.
double length(const ExactComplex& complex, EdgeId e);

/// Where corners of polygons are.
class Corners {
 public:
  /// Keeps references.
  Corners(const SegmentSet& input, const std::vector<Region>& polygons);
  /// The polygon that a segment is of; none for other lines.
  RegionId polygon_of(SegmentId s) const { return polygon_of_[s]; }
  /// Whether the segment ends there. **Exact**.
  bool ends_at(SegmentId s, const Point& p) const;

 private:
  const SegmentSet& input_;
  std::vector<RegionId> polygon_of_;
};

/// The coverage without vertices in the middle of straight sides that are no corners of the
/// polygons on either side.
Coverage straightened(const Coverage& coverage, const SegmentSet& input);

}  // namespace plumbline::coverage_steps
