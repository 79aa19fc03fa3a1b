#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "plumbline/coverage.hpp"
#include "plumbline/overlay.hpp"
#include "plumbline/polygons.hpp"
#include "plumbline/rooms.hpp"
#include "plumbline/round.hpp"

namespace plumbline {

/// Nothing, a number, a count, a text.
using FeatureValue = std::variant<std::monostate, double, std::int64_t, std::string>;

enum class FeatureGeometry { Point, Line, Polygon };

/// What GIS and CAD programs call a feature: a geometry in doubles, with attributes.
struct Feature {
  /// Of a polygon its rings, the outer one first, counter-clockwise, holes clockwise, first points
  /// not repeated; of a line one list of points; of a point one of one point, or none
  /// where it has no place.
  std::vector<std::vector<PointD>> parts;
  std::vector<FeatureValue> values;  ///< one for each column
  std::string layer = {};            ///< of the drawing; CAD programs keep it
};

/// Features of one kind.
struct FeatureLayer {
  std::string name;
  FeatureGeometry geometry = FeatureGeometry::Point;
  std::vector<std::string> columns;
  std::vector<Feature> features;
  bool is_numbered = false;  ///< whether GeoJSON numbers them, from 1, as ids
};

/// Layers of one drawing, as all writers take them.
struct Features {
  std::vector<FeatureLayer> layers;
  std::string crs;   ///< as SegmentSet::crs
  std::string note;  ///< what is to be known of the numbers; where a format has a place for it
  std::vector<Layer> drawing_layers = {};  ///< as SegmentSet::layers
  std::optional<LengthUnit> unit = {};     ///< as SegmentSet::unit
};

/// The bounded faces of the rounded complex as valid polygons (`polygons`). Columns: `face`, its
/// index, `area` and `area_exact` of the exact face (where the rounding has merged or split any, of
/// the polygon itself), `perimeter`,
/// `depth`, `parent`, `neighbours` ("2 5 7"), `layers` (of the drawing, that bound it, "; "
/// between), `sources` (the elements).
FeatureLayer face_layer(const ExactComplex& complex, const SegmentSet& input,
                        const Rounding& rounding);
/// Its edges. Columns: `edge`, `tail`, `head` (vertices), `left`, `right` (faces, 0 the unbounded
/// one), `layers`, `sources` of the segments that cover it; each lies on the layer of the first.
FeatureLayer edge_layer(const SegmentSet& input, const Rounding& rounding);
/// Its vertices. Columns: `vertex`, `degree`.
FeatureLayer vertex_layer(const Rounding& rounding);

/// The rooms as polygons; more than one for a room that the rounding has parted, each then with its
/// own area and perimeter, so that sums are right. Columns: `room`,
/// its number from 1, `name` (all names, "; " between), `area` and `area_exact` of the exact face,
/// `area_m2` where the unit is known, `perimeter`, `layers`, `depth`, `parent`, `neighbours` ("2
/// 5"), `doors` (neighbours behind doors), `face`, that of `face_layer`. Requires: a rounding of
/// the complex of the rooms.
FeatureLayer room_layer(const Rooms& rooms, const Rounding& rounding);

/// The parts of pieces as valid polygons. Columns: `piece`, its number from 1, `first` and
/// `second`, the elements that it lies in ("; " between), `area` and `area_exact` of this part.
/// Requires: a rounding of the overlay's complex.
FeatureLayer piece_layer(const Overlay& overlay, const Rounding& rounding);

/// The polygons of selected regions. Columns: `polygon`, its number from 1, `area` and `area_exact`
/// of it (of its own part where rounding parted it). Requires: a rounding of their complex.
FeatureLayer region_layer(const RegionPolygons& regions, const Rounding& rounding);

/// The rings of each part of a polygon, as of a Feature. Together they are a valid multipolygon.
using PolygonParts = std::vector<std::vector<std::vector<PointD>>>;

/// A polygon that was drawn, as it is now.
struct DrawnPolygon {
  Source source;
  PolygonParts parts;        ///< none: nothing is left of it
  bool is_as_drawn = false;  ///< whether its sides are what they were, to the last digit
  Rational area = 0;         ///< of all parts, **exact**, before rounding
};
/// Those of a coverage, in its order; neighbours share vertices. Requires: the coverage is made of
/// `input`, the rounding of its complex.
std::vector<DrawnPolygon> drawn_polygons(const Coverage& coverage, const SegmentSet& input,
                                         const Rounding& rounding);
/// The parts of what was made of one polygon. **Rounded**, proven to be valid: `safely_rounded`.
PolygonParts polygon_parts(const RegionPolygons& made);
/// A feature for each part. Columns: `polygon`, its number from 1, `id`, `layer`, `source`, the
/// element that it was drawn as, `area` and `area_exact` of all its parts.
FeatureLayer polygon_layer(const std::vector<DrawnPolygon>& polygons,
                           const std::vector<std::string>& files);

/// "nearest doubles, the same incidences as the exact complex, proven".
std::string note_of(const Rounding& rounding);

}  // namespace plumbline
