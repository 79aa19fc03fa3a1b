#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// Largest file that `read` takes, in bytes.
inline constexpr std::uintmax_t kMaxFileSize = std::uintmax_t{1} << 30U;
/// The same for formats that are read piece by piece: all but `.svg`, `.svgz`, `.dxf` and `.lines`.
inline constexpr std::uintmax_t kMaxStreamedFileSize = std::uintmax_t{1} << 36U;

/// The formats that `read` takes, by name; each is that of files that end so.
inline constexpr std::array<std::string_view, 9> kFormats{"svg",  "svgz", "dxf", "lines", "geojson",
                                                          "json", "wkt",  "wkb", "csv"};

/// How a drawing is read where the file leaves a choice.
struct ReadOptions {
  /// One of kFormats; "": what the file's ending says, of a file without one its first bytes.
  std::string format;
  /// Largest distance of a curve from the chords that replace it, in the units of the curve's own
  /// coordinates. 0 stands for a thousandth of the longer side of the curve's bounding box, or
  /// where that is more for a 5000th of the longer side of the drawing's `extent`, over the largest
  /// factor by which the drawing's maps enlarge a curve, but at most a tenth of the curve's longer
  /// side.
  Rational chord_tolerance = 0;
  /// Bound on the deviation of angles whose sine and cosine are not rational, in radians.
  double angle_bound = kAngleBound;
  /// Whether elements that the drawing hides (on layers that are off, frozen or not printed;
  /// `display: none`) are drawn; else they are `rejected`, by layers and with counts.
  bool hidden = false;
  /// Patterns of the layers that are read, all where there are none, and of those that are not: `*`
  /// stands for any characters, `?` for one, letters of ASCII for either case. Of SVG also ids and
  /// labels of elements and of what is above them. A pattern that nothing matches is an error.
  std::vector<std::string> layers = {}, without_layers = {};
  /// Whether the boundaries of a DXF's hatches are drawn, on layers of their own: "WALLS HATCH" for
  /// those on "WALLS".
  bool hatches = false;
  /// The property of GeoJSON features that names their layer, in any case.
  std::string layer_property = "layer";
  /// Whether curves of the drawing may be joined to what they meet, as `evaluate` does it; else
  /// they stay where the file's numbers have them.
  bool join_curves = true;
  /// Whether a number that lies within eight units in the last place of a double of a decimal of at
  /// most 12 digits is that decimal, as programs print doubles: 420.34 for 420.34000000000003;
  /// counted in the ledger.
  bool shortest_decimals = false;
  /// Largest number of segments that formats without hierarchy may have, and of the chords of all
  /// curves; beyond it reading ends with Error Limit. What they become where shared Structs are
  /// repeated is limited by `evaluate`.
  std::size_t max_segments = kAnyNumber;
};

/// The drawing in a file, every number exact. The format is told by ReadOptions::format or by the
/// file name's ending, in either case; of a file without ending by its first bytes, where they are
/// certain. A `.json` is GeoJSON or a LAR model, as its members tell. A pipe is
/// read to its end, within kMaxFileSize; so is `/dev/stdin`, the program's standard input, whatever
/// that is. What the reader does not understand is listed in
/// `rejected`, with its place. Throws: Error BadFile, BadInput (malformed file, unknown ending),
/// Limit (beyond kMaxFileSize; numbers or entities that grow beyond all measure).
Structure read(const std::filesystem::path& file, const ReadOptions& options = {});

/// SVG text as a Structure. `g`, `a`, nested `svg`, `symbol` and `use` become Structs named by
/// their inkscape:label or id, of their inkscape:groupmode as category; what a `use` refers to is
/// stored once. Shapes become Models; curves are chords between exact points of the curve, as the
/// ledger lists. Labels: a `text` at its x and y; of a shape its `title`, else its inkscape:label,
/// else its id unless programs make such (path12, svg_3, _7; `is_generated_id`). Layers are groups
/// of groupmode "layer". Coordinates are user units of the root's viewBox, y downwards, as in the
/// file: its width, height and transform, which map them to a page, are not applied; a width or
/// height in mm, cm, Q, in, pt or pc tells what a user unit is. Transforms, viewports and units are
/// exact, an inch being 96 user units. `rejected` lists by name and line every element that is not
/// understood (image, ...), not drawn or not used, and what follows an error in path data, and
/// counts what is hidden; `remarks` clipping viewports, clip-paths, masks and style sheets, which
/// are not applied. Neither interpreted nor listed: markers, style sheets that neither place nor
/// hide, animation. Columns count bytes of UTF-8. No recursion: depth is limited by memory only.
/// Throws: Error BadInput for malformed XML, a root other than `svg` and a cycle of references;
/// Limit.
Structure read_svg(std::string_view text, const std::string& file_name,
                   const ReadOptions& options = {});

/// DXF, as text (R12 to current) or binary, as a Structure. The model space is the root; a layer in
/// it or in a block is a Struct named by it, of category "layer"; a BLOCK is a Struct stored once,
/// of category "block"; an INSERT refers to it below its map, an array once per copy. What a block
/// has on layer "0" is in the block's own Struct and so belongs to the layer of the INSERT. Models:
/// LINE, LWPOLYLINE, POLYLINE (with bulges, in space, meshes), ARC, CIRCLE, ELLIPSE, SPLINE (by
/// control points), MLINE, 3DFACE, SOLID, TRACE, with `hatches` HATCH; the projection along z.
/// Labels: TEXT, MTEXT, ATTRIB and constant ATTDEF without their formatting, at the point that the
/// file has: that of alignment, or of insertion. Layers have the colours of the table but for
/// colour 7, white or black; hidden are those that are off, frozen or not plotted, as Defpoints
/// is. The unit is that of $INSUNITS. Coordinates are drawing units, y upwards; line weights,
/// widths and thickness are ignored. `rejected` lists with their places what is malformed, missing
/// or extruded in another direction than z, and per kind with counts what is not drawn: other
/// entities, the paper space, what is hidden (entities and edges marked so; layers, one item each);
/// `remarks` z coordinates, which are left out.
/// The ledger lists, per kind, curves by their chords and angles by rational rotations.
/// Source::line is the line of the entity's name; in a binary DXF, of its text form with two lines
/// per group. No recursion. Throws: Error BadInput, with its line, for text that is no sequence of
/// groups, for a text without sections and for a block within itself; Limit.
Structure read_dxf(std::string_view text, const std::string& file_name,
                   const ReadOptions& options = {});

/// LAR's `.lines` text: a row `x1,y1,x2,y2` per segment, blanks around the numbers allowed; empty
/// rows are skipped. A row that is anything else is `rejected`. Throws: Error Limit.
Structure read_lines(std::string_view text, const std::string& file_name,
                     const ReadOptions& options = {});

// The formats below have no hierarchy: elements are in the root, in one table (Model::rows) for
// each kind of element; 80 bytes of memory a segment, ids apart. `read` takes them piece by piece:
// memory grows with the result and with the largest geometry or record. Each line and polygon of a
// geometry of several, or of a collection, is an element: of the second the id is "id/2", or "2"
// where the geometry has none. A named reference system (GeoJSON's `crs`, a SRID n as "EPSG:n") is
// kept in Structure::crs; geometries in another one are listed, and drawn as they are. Lines are
// drawn from point to point, rings as they are: one that is not closed is listed in `remarks` and
// not closed; so is that there are coordinates beyond x and y, which are not used. In `rejected`:
// isolated points, which are not drawn; curved geometries. Of more than 10,000 listed items, each
// further reason is listed once, with a count.

/// GeoJSON (RFC 7946): any object, GeometryCollections of any depth. Sources are named by the id of
/// the feature, else by its property id or name, in any case. The first of its properties name,
/// label, title, room, room_name, roomname and text that is a string is the label of its polygons,
/// and at its points, which are listed otherwise; ReadOptions::layer_property names its layer.
/// `rejected` lists a feature or geometry that breaks the format. Throws: Error BadInput for what
/// is not JSON, and for a document without a known type, with a member twice or with the contents
/// of two types in one object; Limit.
Structure read_geojson(std::string_view text, const std::string& file_name,
                       const ReadOptions& options = {});

/// Geometries in well-known text (OGC SFA 1.2.1; ISO Z, M, ZM; EWKT's SRID), one after the other,
/// with semicolons, blank lines and lines that begin with # between them. Coordinates may be
/// fractions p/q. Throws: Error BadInput for anything else.
Structure read_wkt(std::string_view text, const std::string& file_name,
                   const ReadOptions& options = {});

/// The same in well-known binary (also EWKB), as bytes or as hexadecimal digits. Coordinates are
/// the dyadic rationals that their doubles are. Of bytes, sources have no place; they are named by
/// the number of their geometry, from 1.
Structure read_wkb(std::string_view bytes, const std::string& file_name,
                   const ReadOptions& options = {});

/// Comma-separated values (RFC 4180; also semicolons or tabs, and `sep=`). A header names the
/// columns x1, y1, x2, y2 or ax, ay, bx, by, or one of wkt, geom, geometry, the_geom with
/// well-known text or hexadecimal binary; and id, fid, gid or name. Without a header a row is four
/// numbers. A row that can't be drawn is `rejected`. Throws: Error BadInput for a first row that is
/// neither and for a quote that is not closed; Limit.
Structure read_csv(std::string_view text, const std::string& file_name,
                   const ReadOptions& options = {});

/// A LAR model as JSON: members V (points), EV (pairs of indices), FV (lists of indices),
/// index_base (0, or 1 as in Julia; 0 if it is not there), or lines (pairs of points); or the list
/// [V, EV], [V, FV] or [V, FV, EV]. Edges are drawn, each an
/// element with its place. Without any, the faces become a LarModel. Throws: Error BadInput for
/// anything else, an index out of range in particular.
/// Also a bare list of segments, [[[x1, y1], [x2, y2]], ...]; two of them whose second one could be
/// edges between the ends of the first are refused, as a model and segments alike.
Structure read_lar_json(std::string_view text, const std::string& file_name,
                        const ReadOptions& options = {});
/// A LAR structure as JSON: {"root": name, "defs": {name: definition, ...}}. A definition is a
/// Struct {"body": [...]} of references {"ref": name}, maps {"op": "t" | "s" | "r", "args": [...]}
/// (radians), {"op": "r", "degrees": x} or {"mat": [[...], ...]}, models and Structs; or a model:
/// {"V", "CV"}, {"V", "FV", "EV"}, {"V", "cells"}, {"lines": [[[x, y], [x, y]], ...]} or the grid
/// {"shape": [...]}. Numbers are decimals, or strings "p/q". Documented in docs/json.md. Rotations
/// that are replaced are in the ledger. Throws: Error BadInput, with its place, for anything else,
/// a cycle of references and mixed dimensions among it; Limit.
Structure read_struct_json(std::string_view text, const std::string& file_name,
                           const ReadOptions& options = {});

}  // namespace plumbline
