#pragma once

// The only public header that names CGAL. Link target plumbline::cgal to use it.

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

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

/// The arrangement itself; the data of an edge's curve are the segments that cover it, of equal
/// segments the first. **Exact**. Cost: that of CGAL's sweep, which is cubic in the number of
/// collinear segments that overlap in one place.
Arrangement arrangement(const SegmentSet& input);
/// The canonical complex of the arrangement of the input, equal segments included. **Exact**.
ExactComplex to_complex(const Arrangement& arrangement, const SegmentSet& input);

}  // namespace plumbline::cgal
