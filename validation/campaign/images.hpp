#pragma once

#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/structure/affine.hpp"

/// What an exact complex becomes when its input is changed in a known way; all results are
/// canonical.
namespace plumbline::campaign {

/// Each source called by the id in `original`; equal ones once.
ExactComplex renamed(ExactComplex complex, const std::vector<SegmentId>& original);
/// Negative for a map of the plane that turns it over, 0 for one that is not invertible.
int determinant_sign(const Affine& map);
/// The image under a map, which may turn the plane over. Requires: it is invertible.
ExactComplex mapped(ExactComplex complex, const Affine& map);
/// With one more vertex at p, which cuts the edge that p is on. The same where p is a vertex.
/// Requires: p is on an edge or a vertex.
ExactComplex with_vertex(ExactComplex complex, const Point& p);
/// The complex and a copy of it, moved, whose sources come `segments` later. Requires: neither lies
/// in a bounded face of the other, and they do not meet.
ExactComplex with_copy(const ExactComplex& complex, const Affine& move, std::size_t segments);
/// Edges that have themselves as sources: what is to come out when the edges are the input.
ExactComplex sourced_by_itself(ExactComplex complex);

}  // namespace plumbline::campaign
