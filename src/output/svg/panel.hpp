#pragma once

#include <string>
#include <vector>

#include "output/svg/kit.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::svg {

/// Cells drawn in the second colour.
struct Marks {
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
};

/// The complex as SVG elements: faces filled by depth (the unbounded face not; holes are cut out),
/// edges as thin lines, antennas dashed, isolated vertices as dots, marked cells on top in the
/// second colour. `of_lines` are more attributes of the edges. No path of edges is longer than 1
/// MB. y runs downwards, as in the drawing. **Rounded**. Requires: `canonical` was called, finite
/// coordinates; the complex need not be valid. Cost: O(V + E + F).
std::string panel(const FloatComplex& complex, const Frame& frame, double pen,
                  const Marks& marks = {}, const std::string& of_lines = {});

/// The path of a face with its holes, to fill by the rule even-odd; "" for the unbounded one of a
/// complex in one piece.
std::string face_path(const ExactComplex& complex, FaceId f, const Frame& frame);

/// All edges as thin lines, some thousands to a path: viewers choke on very long ones.
std::string edge_paths(const ExactComplex& complex, const Frame& frame, double pen);

}  // namespace plumbline::svg
