#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/engine.hpp"

namespace plumbline::files {

/// An arrangement that another program made, as its file says, right or wrong.
struct Result {
  std::string file;
  /// In canonical order, without sources. Its doubles are taken as the rationals that they are;
  /// coordinates of an arrangement that this program wrote are those of its file, exactly.
  ExactComplex complex;
  /// Whether the file has faces. If not, the complex has none, and vertices and edges alone can be
  /// compared.
  bool has_faces = false;
  /// Whether its edges are all there are to it, or just those around its faces: polygons alone.
  bool has_edges = true;
  /// Vertices that a ring of a polygon goes past in line, which another polygon has; they are put
  /// into it.
  std::vector<PointD> passed;
  std::vector<Rejected> rejected;  ///< what of the file is not in the complex
  std::vector<Remark> remarks;
};

/// The result in a file; `complex_from_faces` says what becomes of faces that overlap, leave gaps
/// or are otherwise wrong. Numbers are read as the nearest doubles. By the file name's ending, or
/// as `read` takes what has none, and pipes:
/// - `.geojson`, `.json`: GeoJSON. Each polygon is a face, lines are edges between successive
///   points. Points with the same coordinates are one vertex.
/// - `.wkt`, `.wkb`, `.csv`: the same in well-known text or binary, as `read` takes them.
/// - `.json`: a LAR model, {V, EV}, {V, FV} or {V, FV, EV}, the list [V, EV], [V, FV] or
///   [V, FV, EV], with `polygons` (per face its outer boundary and its holes) in place of FV where
///   they are there. Vertices with the same coordinates are several, EV lists all edges,
///   one of a single vertex joins it to itself. A cell of
///   FV is a cycle of vertices; or, where EV does not join them in this order, the set of vertices
///   of the cycles that EV has among them, or of a face of the graph (V, EV). Indices count from
///   `index_base`; without it from 0, or from 1 where that alone fits (some index is the number of
///   vertices, none is 0).
/// - `.json`: a bare list of segments, as edges.
/// - `.json`: what `arrange --output` and `lar --trace` of this program write.
/// Throws: Error BadFile; BadInput for a malformed file, an unknown ending, an index out of range;
/// Limit.
Result read(const std::filesystem::path& file);

/// The formats of a `.json` file one by one.
Result read_geojson(std::string_view text, const std::string& file_name);
Result read_lar(std::string_view text, const std::string& file_name);
Result read_arrangement(std::string_view text, const std::string& file_name);
Result read_wkt(std::string_view text, const std::string& file_name);

/// The result as an answer for `check`. Its title is the file; it has no stages.
Answer answer(Result result);

/// The same as an engine, with the parameter file; its name is "files".
Engine engine();

}  // namespace plumbline::files
