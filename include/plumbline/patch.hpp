#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/features.hpp"

namespace plumbline {

/// The text of a drawing with some of its elements replaced.
struct Patch {
  std::string text;
  std::vector<Source> replaced;  ///< the elements, in the file's order
};

/// The DXF text byte by byte, but for elements whose segments changed: these are taken out, and
/// their lines in the output put there as LINEs on the same layer, in the same colour and the like;
/// of what blocks hold, and of lines that no element of the input has, at the end of the entities.
/// kVirtualLayer becomes a layer of the table. Coordinates are exact where they are decimals, else
/// nearest doubles. None where that cannot be done: a binary file, places that are not those of the
/// text. `also`: per source of the input whether it counts as changed in any case; empty: none.
/// Requires: sources of the output begin with those of the input.
std::optional<Patch> patched_dxf(std::string_view text, const SegmentSet& input,
                                 const SegmentSet& output, const std::vector<bool>& also = {});

/// The same for SVG: lines are paths in a group at the end of the root, in its coordinates, those
/// of layers in groups that Inkscape takes as such. A path keeps id, class, style and strokes of
/// its element, and what stood within that; it is not filled.
std::optional<Patch> patched_svg(std::string_view text, const SegmentSet& input,
                                 const SegmentSet& output, const std::vector<bool>& also = {});

/// The GeoJSON text byte by byte, but for geometries of polygons that are not as they were drawn: a
/// Polygon or MultiPolygon of doubles takes their place, one without coordinates where nothing is
/// left. Features keep ids, properties and other members. None where that cannot be done: places
/// are not those of the text, or a geometry of a feature's several is not among the polygons.
/// Requires: all polygons that were read, as they stand in the file.
std::optional<Patch> patched_geojson(std::string_view text,
                                     const std::vector<DrawnPolygon>& polygons);

}  // namespace plumbline
