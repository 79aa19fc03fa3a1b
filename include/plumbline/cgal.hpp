#pragma once

// The only public header that names CGAL. Link target plumbline::cgal to use it.

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::cgal {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Segments that carry the set of SegmentIds that cover them.
using Traits =
    CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, SegmentId>;
using Arrangement = CGAL::Arrangement_2<Traits>;

/// Throws: Error Limit for a coordinate beyond kMaxCoordinateBits.
Kernel::Point_2 to_cgal(const Point& p);
Kernel::Segment_2 to_cgal(const Segment& s);
Point from_cgal(const Kernel::Point_2& p);
/// Doubles, taken as the dyadic rationals that they are. Requires: finite; throws Error BadInput.
Point from_cgal(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_2& p);

/// The arrangement itself; the data of an edge's curve are the segments that cover it, of equal
/// segments the first. **Exact**. Cost: that of CGAL's sweep, which is cubic in the number of
/// collinear segments that overlap in one place.
Arrangement arrangement(const SegmentSet& input);
/// The canonical complex of the arrangement of the input, equal segments included. **Exact**.
ExactComplex to_complex(const Arrangement& arrangement, const SegmentSet& input);

/// The edges of any arrangement of line segments, whatever data they carry, and its isolated
/// vertices: what `arrange` makes the complex of. **Exact**. Requires: points that `from_cgal`
/// takes. Order: segment k is the edge k of `edges_begin()`; one beyond the limit of numbers is
/// rejected.
template <class AnyTraits, class Dcel>
SegmentSet segments(const CGAL::Arrangement_2<AnyTraits, Dcel>& arrangement) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    set.add(Segment{from_cgal(e->source()->point()), from_cgal(e->target()->point())}, source);
  }
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
    if (v->is_isolated()) set.add_point(from_cgal(v->point()), source);
  }
  return set;
}

/// The bounded faces: what `plumbline::polygons` has, in its order. **Exact**. Throws: as that, and
/// as `to_cgal`.
std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons(const ExactComplex& complex);

}  // namespace plumbline::cgal
