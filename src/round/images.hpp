#pragma once

#include "plumbline/round.hpp"

namespace plumbline::round_steps {

/// Per exact edge the halfedges of the rounded complex that its chain of rounded vertices runs
/// along. Throws: Error Internal where there is no such edge.
Lists<HalfedgeId> edge_images(const Incidences& rounded, const Lists<VertexId>& chains);

/// Per rounded face the exact face that it comes from. Throws: Error Internal where the sides of
/// the exact edges contradict each other: the motion from the exact to the rounded edges has then
/// carried a vertex across an edge.
std::vector<FaceId> face_origins(const Incidences& exact, const Incidences& rounded,
                                 const std::vector<VertexId>& vertex_image,
                                 const Lists<HalfedgeId>& edge_image);

/// Checks of a rounding what `ensure_rounded` does but for two things: that the rounded complex is
/// valid, and that no vertex went past an edge. Throws: as it.
void ensure_images(const ExactComplex& complex, const Grid& grid, const Rounding& rounding);

}  // namespace plumbline::round_steps
