#pragma once

#include <optional>
#include <span>
#include <string>

#include "plumbline/check.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/diagnose.hpp"
#include "plumbline/edits.hpp"
#include "plumbline/features.hpp"
#include "plumbline/rooms.hpp"
#include "plumbline/round.hpp"

namespace plumbline {

struct LarModel;
struct Structure;

// All that is written, one function for each form: text for a terminal, JSON, SVG, GeoJSON, a page
// of HTML, rows of lines, a certificate. Every JSON is documented in docs/json.md.

/// The complex as JSON: vertices (exact text and nearest double), edges with their sources, faces
/// with cycles of signed edges, area, depth, interior point; components; rejected items; ledger;
/// signature.
std::string to_json(const ExactComplex& complex, const SegmentSet& input);

/// The same complex in a third of the bytes, without what follows from the rest: exact vertices,
/// edges with the segments that cover them and faces, as arrays. The segments are those of the
/// input.
std::string to_compact_json(const ExactComplex& complex, const SegmentSet& input);

/// As `to_json`, with numbers that are proven to be those of the same complex: of `complex` itself
/// where the rounding keeps its incidences, else of the snap rounded complex, and what has changed.
std::string to_json(const ExactComplex& complex, const SegmentSet& input, const Grid& grid,
                    const Rounding& rounding);

/// The structure as JSON that `read_struct_json` reads back: definitions in order, references by
/// name, rotations as the exact matrices that they became. Throws: Error BadInput for a reference
/// to no Struct.
std::string to_json(const Structure& structure);

/// The model as JSON: V and CV, V, FV and EV, or V and cells. Decimals are numbers, other
/// coordinates strings "p/q".
std::string to_json(const LarModel& model);

/// The complex as a LAR model (V, FV, EV): `FV` has for each bounded face the vertices of its outer
/// boundary, then those of its holes, edges that end within it left out; where there are holes,
/// `polygons` has per face its boundaries one by one. Decimals are numbers, other coordinates
/// strings "p/q". **Exact**; `read` and `check --against` take it.
std::string to_lar_json(const ExactComplex& complex);

/// The complex as an SVG picture, in the drawing's own coordinates: faces filled by nesting depth,
/// edges, antennas dashed, a legend; y negated where it runs upwards. What is stray is out of
/// sight. A drawing far from (0, 0) has local ones: a `desc`, and `data-plumbline-transform`, which
/// `read_svg` applies, lead back. **Rounded** to nearest doubles.
std::string to_svg(const ExactComplex& complex, bool y_up = false);

// Features in doubles, as `safely_rounded` has proven them to be a valid partition: each number is
// the shortest decimal that reads back as it.

/// RFC 7946, but in the drawing's own coordinates: a FeatureCollection; of several layers each
/// feature has the property `layer`. The member `numbers` is the note, `crs` the reference system.
std::string to_geojson(const Features& features);
/// TopoJSON without quantisation: an object for each layer, whose polygons and lines are arcs. An
/// arc goes on until lines or sides of polygons part there, or a line ends. Properties, `numbers`
/// and `crs` as above.
std::string to_topojson(const Features& features);
/// Well-known text, a geometry a line: what GEOS, JTS, PostGIS and `read` read.
std::string to_wkt(const Features& features);
/// RFC 4180, with a column `wkt`.
std::string to_csv(const FeatureLayer& layer);
/// Well-known binary in hexadecimal digits, a geometry a line.
std::string to_wkb_hex(const Features& features);

/// DXF R2000 (AC1015) as text. Lines of one layer that go on from each other are joined to a
/// polyline, polygons are a closed polyline for each ring, points points; where a layer has a
/// column `name`, its texts stand within their polygons. On the feature's layer, else on one of the
/// feature layer's name; of what DXF forbids in names each character is a "_". The note is a
/// comment.
std::string to_dxf(const Features& features);

/// Wavefront OBJ: vertices (z is 0), edges as lines in the group `edges`, each bounded face as
/// triangles in a group `face_F`. What is written is the rounded complex; the note is a comment.
std::string to_obj(const Rounding& rounding);

/// What is stray, for people: "1 element lies 4,000 drawing sizes away: layer X,
/// plan.dxf:312 LINE 2F"; of several the first one is named. "" where nothing is.
std::string stray_text(const SegmentSet& input);

/// The segments as an SVG picture of lines, in the same way.
std::string to_svg(const SegmentSet& input);

/// The segments as rows "x1,y1,x2,y2", which `read` takes as a .lines file; the shortest decimals
/// that round to the coordinates.
std::string to_lines(std::span<const SegmentD> segments);

/// The segments in their order as rows "x1,y1,x2,y2" and the isolated points as rows "x,y", with
/// `exact_text`s. **Exact**. `read` takes it as a .lines file (it lists the points as rejected),
/// plumbline-verify as the input of a certificate.
std::string to_lines(const SegmentSet& input);

/// The edges in their order as such rows, with whole decimal expansions: what they say is the
/// complex itself, but for its isolated vertices and sources. **Exact**. Requires: coordinates are
/// decimals, as those of a Rounding are; throws Error BadInput.
std::string to_lines(const ExactComplex& complex);
/// Whether all coordinates are decimals.
bool are_decimals(const ExactComplex& complex);

/// The certificate of an exact arrangement: the complex, and for each cell what is needed to check
/// it against the input without trusting who made it; `plumbline-verify` does. The format is in
/// docs/certificate.md. **Exact**. Requires: `complex` is what `arrange` returns for `input`.
/// Order: canonical; the same bytes whatever the engine and the number of threads. Cost: linear,
/// and an `interior_point` for each face. Throws: Error Internal where the complex is not that of
/// the input and this is noticed; that no claim is wrong is for the checker to say.
std::string certificate(const ExactComplex& complex, const SegmentSet& input);

/// The verdict for a terminal: what to do, counts side by side, where findings come from, then the
/// groups of findings, numbered: `listed` of them with their findings, or as many as fit on a
/// screen of 40 lines.
std::string to_text(const Check& check, std::optional<std::size_t> listed = {});
/// The same as JSON, all findings.
std::string to_json(const Check& check);
/// Two panels of the same drawing, exact and float: faces filled by depth, edges, every finding
/// marked in a second colour, with the number of its group at the place to look at.
std::string to_svg(const Check& check);
/// A page to look at all of it with a browser: pan and zoom, layers, findings, faces, the ladder.
/// One file that loads nothing else. Cost: some 20 bytes an edge and complex.
std::string to_html(const Check& check);
/// The findings of the float result as a layer of points, none for kind Complex, numbered; on
/// layers (Feature::layer) by what disagrees.
FeatureLayer finding_layer(const Check& check);

/// A tolerance ladder for a terminal: a table of its first `limit` steps. Requires: the ladder of
/// this complex.
std::string to_text(const ToleranceLadder& ladder, const ExactComplex& complex,
                    std::size_t limit = 20);
/// The same as a picture: vertices, edges and faces over the logarithm of the radius; radii for
/// which the float result is right in green.
std::string to_svg(const ToleranceLadder& ladder, const std::optional<RightRadii>& radii = {});

/// The diagnosis for a terminal, on a screen: how many defects of each kind, those that matter
/// most, openings, what tolerances would mend; then `limit` of each kind with their places and
/// elements. Numbers are positions in Diagnosis::defects, from 1, here and below.
std::string to_text(const Diagnosis& diagnosis, const SegmentSet& input, std::size_t limit = 0);
/// The same as JSON, all that are listed.
std::string to_json(const Diagnosis& diagnosis, const SegmentSet& input);
/// Those, and then the openings, as a layer of points, as of a check; on layers by kind.
FeatureLayer defect_layer(const Diagnosis& diagnosis, const SegmentSet& input);
/// A panel for each kind that was found: the drawing with the defects marked by their numbers.
std::string to_svg(const Diagnosis& diagnosis, const SegmentSet& input,
                   const ExactComplex& complex);

/// The rooms for a terminal, a table: the `listed` largest ones, or as many as fit on a screen, in
/// the order of their numbers; what was left out, and texts in no room.
std::string to_text(const Rooms& rooms, const SegmentSet& input,
                    std::optional<std::size_t> listed = {});
/// The same as JSON, all rooms.
std::string to_json(const Rooms& rooms, const SegmentSet& input);
/// A plan: rooms in colours, different ones beside each other, with number, first name and area; a
/// list of them and a scale bar.
std::string to_svg(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex);
/// The plan with a table of rooms beside it, to search and to sort: one file that loads nothing
/// else.
std::string to_html(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex);

/// "weld 0.01, grow off, ..., doors 0.6..1.2".
std::string to_text(const Tolerances& tolerances);
/// "7 edits: 3 ends grown by up to 0.02, ...; 1 room closed; 2 refused".
std::string repair_line(const Repair& repair);
/// The repair for a terminal: that line, tolerances and why, then the edits that do most to faces,
/// with place, element and size, `listed` of them or as many as fit on a screen; refused ones.
/// Numbers are positions in Repair::edits, from 1, here and below.
std::string to_text(const Repair& repair, const SegmentSet& input,
                    std::optional<std::size_t> listed = {});
/// A picture: the drawing after, with what was added, removed and moved, the edits that do most by
/// their numbers, faces that were closed, split and joined, which part of their borders is virtual.
/// `before` and `after` are the arrangements of the input and of the output, here and below.
std::string to_svg(const Repair& repair, const SegmentSet& input, const ExactComplex& before,
                   const ExactComplex& after);
/// A page: the drawing before, after or both, and lists of edits, of what was refused and of faces,
/// to search and to click through. One file that loads nothing else.
std::string to_html(const Repair& repair, const SegmentSet& input, const ExactComplex& before,
                    const ExactComplex& after);
/// The log as JSON: tolerances, edits, faces, what was refused.
std::string to_json(const Repair& repair, const SegmentSet& input);
/// A repaired drawing as a layer of lines, on the layers of their elements. Columns: `line`,
/// `layer`, `source` (the element), `id` (of it), `virtual` (1 for those on kVirtualLayer, else 0).
FeatureLayer line_layer(const SegmentSet& lines);
/// The edits, and then what was refused, as a layer of points; on layers by kind.
FeatureLayer edit_layer(const Repair& repair, const SegmentSet& input);

}  // namespace plumbline
