#pragma once

#include <string>
#include <vector>

#include "plumbline/engines/lar.hpp"

namespace plumbline {

/// What a picture of a run of the float pipeline shows, of LAR's `arrange` or of `inters`.
enum class LarShow {
  Buckets,     ///< the segments, in the colour of the first bucket that holds them
  Components,  ///< biconnected components in colours, bridges and dangling edges dashed
  Faces,       ///< the faces of the result in colours
  Explode,     ///< the same, pulled apart
  Numbers,     ///< the numbers of vertices, edges and faces
  Pruning,     ///< vertices before merging, clusters with their radii and centroids
  // Of the faces; inters: of the cells of `two_complex` where it has a value.
  Filled,     ///< triangulated; those whose edges cross are empty and in the second colour
  Polylines,  ///< boundaries, joined by their bridge edges
  Boundary,   ///< numbered; chosen ones filled, with the boundary of their chain
};
struct LarPicture {
  LarShow show = LarShow::Faces;
  double explode = 1.2;                 ///< factor of the exploded view
  bool y_up = false;                    ///< whether y runs upwards
  std::vector<std::size_t> faces = {};  ///< chosen bounded faces, counted from 0; none: all
};
/// A picture of the run as SVG. Colours depend on the numbers of the cells alone. Throws: Error
/// BadInput for a factor below 1, a chosen face that is not there, and bridge edges of a complex
/// that is not valid.
std::string to_svg(const lar::Result& result, const LarPicture& options = {});

/// The run as JSON, every stage by the keys that the original's recorded outputs have where the
/// stages are the same. Documented in docs/json.md.
std::string to_json(const lar::Result& result);

}  // namespace plumbline
