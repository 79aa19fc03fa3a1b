#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// What kind of cell a finding is about.
enum class CellKind { Vertex, Edge, Face, Hole, Complex };

/// How the float result differs from the exact complex.
enum class Disagreement {
  Invalid,      ///< the float result by itself breaks an invariant of a complex
  Missing,      ///< an exact cell has no float counterpart
  Extra,        ///< a float cell has no exact counterpart
  Merged,       ///< several exact cells are one float cell
  Split,        ///< one exact cell is several float cells
  Moved,        ///< a vertex corresponds, but lies further away than the tolerance
  Reshaped,     ///< a face or hole corresponds, but its boundary has other cells
  WrongParent,  ///< a face or component corresponds, but lies in another face
};
std::string to_text(CellKind kind);
std::string to_text(Disagreement disagreement);

/// One disagreement. Numbered from 1 by its position in Comparison::findings.
struct Finding {
  CellKind kind = CellKind::Complex;
  Disagreement disagreement = Disagreement::Invalid;
  std::optional<Invariant> invariant;    ///< the one that is broken; of Invalid only
  std::string message;                   ///< one sentence
  Point where;                           ///< exact place to look at
  std::vector<std::size_t> exact_cells;  ///< indices of cells of `kind` (Hole: cycles), exact side
  std::vector<std::size_t> float_cells;  ///< the same in the float complex
  std::optional<double> distance;        ///< how far things moved, in drawing units
  std::optional<Rational> squared_distance;  ///< its square, exact
  std::optional<Rational> area;              ///< of the symmetric difference of the faces, exact
  /// Of a face that is Missing or Extra the face of the other side at its place, where one is.
  std::optional<std::size_t> lies_in;
  std::vector<SegmentId> segments;   ///< the input segments involved, ascending
  std::vector<std::size_t> because;  ///< numbers of earlier findings that it follows from
};

/// Which cells are compared.
enum class Compared {
  All,
  Graph,  ///< vertices and edges, of a result that has no faces
  /// Faces and what bounds them, of a result that has polygons alone: no edges with the same face
  /// on both sides (dangling ones, bridges), no isolated vertices, no vertices that only such
  /// edges make of a straight side.
  Faces,
  SomeFaces,  ///< each bounded face of the result, and nothing that it has not
  Nothing,    ///< there is no result
};
std::string to_text(Compared compared);  ///< "all", "graph", "faces", "some faces", "nothing"

struct Comparison {
  double tolerance = 0;
  Compared compared = Compared::All;
  std::size_t edges_left_out = 0, vertices_left_out = 0;  ///< exact ones, of Faces
  Counts exact_counts, float_counts;                      ///< of the whole complexes
  /// Pairs that match one to one; of faces those with the same outer boundary.
  std::size_t matched_vertices = 0, matched_edges = 0, matched_faces = 0;
  double largest_displacement = 0;  ///< of a matched vertex
  bool float_valid = false;         ///< no finding of kind Invalid
  std::vector<Finding> findings;    ///< Invalid first, then vertices, edges, faces, holes

  /// The two agree: the float result is a valid complex and every cell matches one to one.
  bool agree() const { return findings.empty(); }
};

/// Holds a float complex against the exact one of the same drawing. Two questions, kept apart: is
/// the float result, its doubles taken as exact, a valid complex; and do vertices, edges, faces,
/// holes and nesting match the exact ones one to one, vertices within `tolerance` (compared
/// exactly)? They agree just if both answers are yes. **Exact**, but how cells that do not match
/// are put together in findings is **heuristic** (nearest vertices, common neighbours, chains
/// within the tolerance, which face covers most of another). A finding that follows from earlier
/// ones names them. Requires: both in canonical order; the float complex need not be valid.
/// Degenerate: vertices nearer to each other than the tolerance match by their order of nearness.
/// Order: findings do not depend on input order beyond SegmentIds. Cost: O(n log n) where the two
/// agree, less than their exact arrangement; that of `validate` and of an overlay of the faces
/// that differ where they do not; a tolerance larger than the drawing's features costs up to some
/// hundred operations a cell. Throws: Error BadInput for a tolerance that is negative or not
/// finite, or a coordinate that is not finite.
Comparison compare(const ExactComplex& exact_complex, const FloatComplex& float_complex,
                   double tolerance);
/// The same of two exact complexes: the second one takes the place of the float complex. Of Graph,
/// what its faces and cycles are does not matter. Of Faces the exact complex must be valid.
Comparison compare(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                   double tolerance, Compared compared = Compared::All);

}  // namespace plumbline
