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

/// The steps from the file to the float result. Parse and transform belong to the conversion of
/// the drawing, the others to the float pipeline (of both variants) or, where the result came from
/// a file, to nobody: Foreign.
enum class Stage {
  Parse,            ///< a number of the file became the nearest double
  Transform,        ///< a coordinate that maps or shapes gave became the nearest double
  Quantise,         ///< rounded to fixed decimals, or written with few digits
  Bucket,           ///< two segments that meet share no bucket
  Intersect,        ///< a meeting missed, invented or misplaced
  Order,            ///< cuts along a segment in the wrong order
  Prune,            ///< vertices merged within the radius
  Simplify,         ///< edges lost or kept over merged vertices
  ComponentFilter,  ///< bridges, dangling edges, components left out
  EdgeOrder,        ///< wrong order of edges around a vertex
  FaceWalk,         ///< cycles that are no boundaries
  OuterFace,        ///< a wrong cycle taken for the outer boundary
  Nesting,          ///< components in wrong faces, holes left out
  Foreign,          ///< somewhere in a result that came from a file
};
std::string to_text(Stage stage);

/// Why a finding is there.
struct Cause {
  Stage stage = Stage::Foreign;
  std::size_t round = 0;    ///< of cutting and merging, from 1; 0 outside of rounds
  std::string rule;         ///< the name of the divergence, as in docs/divergences.md
  std::string explanation;  ///< one sentence: what the stage did there
  std::string advice;       ///< one sentence: what would have avoided it
  /// The stage alone makes the finding: with its output continued exactly it is there, with its own
  /// input continued exactly it is not.
  bool confirmed = false;
  /// With the stage replaced by its exact counterpart and the later ones run as they are, these
  /// make the finding again. None: not tried, as for Parse and Transform, and on large drawings.
  std::optional<bool> remade;
};

/// One disagreement. Numbered from 1 by its position in Crosscheck::findings.
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
  std::vector<SegmentId> segments;           ///< the input segments involved, ascending
  std::vector<std::size_t> because;          ///< numbers of earlier findings that it follows from
  std::optional<Cause> cause;                ///< filled in by `check`
};

/// Which cells are compared.
enum class Compared {
  All,
  Graph,  ///< vertices and edges, of a result that has no faces
};

struct Crosscheck {
  double tolerance = 0;
  Compared compared = Compared::All;
  Counts exact_counts, float_counts;
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
/// agree, less than their exact arrangement; that of `validate` and of an arrangement of the faces
/// that differ where they do not; a tolerance larger than the drawing's features costs up to some
/// hundred operations a cell. Throws: Error BadInput for a tolerance that is negative or not
/// finite, or a coordinate that is not finite.
Crosscheck crosscheck(const ExactComplex& exact_complex, const FloatComplex& float_complex,
                      double tolerance);
/// The same of two exact complexes: the second one takes the place of the float complex. Of Graph,
/// what its faces and cycles are does not matter.
Crosscheck crosscheck(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                      double tolerance, Compared compared = Compared::All);

}  // namespace plumbline
