#pragma once

#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/structure/affine.hpp"

/// What an exact complex becomes when its input is changed in a known way; all results are
/// canonical.
namespace campaign {

/// Each source called by the id in `original`; equal ones once.
plumbline::ExactComplex renamed(plumbline::ExactComplex complex,
                                const std::vector<plumbline::SegmentId>& original);
/// Negative for a map of the plane that turns it over, 0 for one that is not invertible.
int determinant_sign(const plumbline::Affine& map);
/// The image under a map, which may turn the plane over. Requires: it is invertible.
plumbline::ExactComplex mapped(plumbline::ExactComplex complex, const plumbline::Affine& map);
/// With one more vertex at p, which cuts the edge that p is on. The same where p is a vertex.
/// Requires: p is on an edge or a vertex.
plumbline::ExactComplex with_vertex(plumbline::ExactComplex complex, const plumbline::Point& p);
/// The complex and a copy of it, moved, whose sources come `segments` later. Requires: neither lies
/// in a bounded face of the other, and they do not meet.
plumbline::ExactComplex with_copy(const plumbline::ExactComplex& complex,
                                  const plumbline::Affine& move, std::size_t segments);
/// Edges that have themselves as sources: what is to come out when the edges are the input.
plumbline::ExactComplex sourced_by_itself(plumbline::ExactComplex complex);

}  // namespace campaign
