#pragma once

#include "certificates/damage.hpp"

namespace plumbline::certificates {

/// Edges run on through vertices: all that come to a vertex on a segment and go on along the same
/// one, at one vertex or at many. Crossings that no edge is left at are gone. What is left covers
/// the input and every vertex has its reason, but edges cross, or run through vertices.
void forget_meetings(Fields& fields, Random& random);

}  // namespace plumbline::certificates
