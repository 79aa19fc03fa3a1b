#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/rings.hpp"

namespace plumbline {

/// What is wrong with line work, in the words of CAD and GIS (AutoCAD Map's drawing cleanup, GRASS
/// v.clean, QGIS' geometry checker, dangles and cut edges of the JTS polygonizer). "Near" is no
/// further than the search distance. A *tip* is a vertex of degree 1; its *line* is the chain of
/// edges from it to the first vertex that is not of degree 2. A tip is of one kind: gap, undershoot
/// or overshoot, whichever is the shortest distance, else dangle.
enum class DefectKind {
  Duplicate,   ///< input segments with the same two ends, in either direction: one defect a group
  Overlap,     ///< two different collinear input segments that share more than a point
  Gap,         ///< two tips near each other; their lines do not run side by side there (within 30
               ///< degrees), are not one line as short as that, and neither is ahead of the other's
               ///< edge; or several that lead to one point
  Undershoot,  ///< a tip near an edge that is ahead: no more than 60 degrees off the line's
               ///< direction; near a tip of it only where the line leads to the edge's inside
  Overshoot,   ///< a line no longer than the search distance from a vertex that one of its segments
               ///< runs through to a tip; or from where an undershoot leads to
  NearMiss,    ///< a vertex near an edge that no short way along the edges leads to, or near a
               ///< vertex; no tip of the kinds above
  Dangle,      ///< a line that ends at a tip, or at two
  Bridge,      ///< a chain of edges with the same face on both sides that is part of no dangling
               ///< tree: the only connection of two closed parts ("cut edge")
  Sliver,      ///< a bounded face that is thin (mean width 2 area / perimeter within the search
               ///< distance) and long (4 pi area / perimeter^2 at most pi / 10: a rectangle 8 x 1)
  ShortEdge,   ///< an edge no longer than the search distance that ends at no tip, is not part
               ///< of a finely drawn line, no whole segment, and closes no strip of parallel edges
  NearlyParallel,  ///< two edges that leave a vertex at an angle of sine 1/100 or less, further
                   ///< than the search distance from each other in the end
  InvalidRing,     ///< what makes a polygon not valid, or a closed line not simple (`RingFault`)
};
inline constexpr std::size_t kDefectKinds = 12;
/// "duplicate", "near-miss", "short edge", ...
std::string to_text(DefectKind kind);

/// One defect.
struct Defect {
  DefectKind kind = DefectKind::Duplicate;
  std::string message;  ///< one sentence
  Point where;          ///< exact place to look at
  /// Of Duplicate and Overlap what is drawn twice, of Dangle, Overshoot, Bridge and ShortEdge a
  /// length, of Gap, Undershoot and NearMiss a distance, of Sliver the mean width, of
  /// NearlyParallel the sine of the angle. **Rounded**, within some units in the last place.
  double size = 0;
  /// Its square, **exact**; none for a Sliver and for lengths of more than one edge.
  std::optional<Rational> squared_size;
  std::optional<Rational> area;  ///< of a Sliver, **exact**
  /// Of Gap and Undershoot, where joining parts two faces, once all of them are joined: the area of
  /// the lesser one, which is open there. **Rounded**.
  std::optional<double> open_area;
  std::optional<RingProblem> ring;  ///< of InvalidRing
  /// The least tolerance (a radius within which lines are snapped, or up to which they are removed)
  /// that mends it: the size, rounded up; 0 for repetitions. None where no tolerance within the
  /// search distance does.
  std::optional<double> proposed_tolerance;
  std::vector<VertexId> vertices;   ///< the tips, the vertex, the pair of vertices
  std::vector<EdgeId> edges;        ///< the line; the edge that is near
  FaceId face;                      ///< of a Sliver
  std::vector<SegmentId> segments;  ///< the input segments involved, ascending
};

/// A way through a line, or through a wall drawn by both faces, that is as wide as a door. No
/// defect.
struct Opening {
  Point where;                      ///< its middle
  double width = 0;                 ///< **Rounded**
  Rational squared_width;           ///< **exact**
  std::vector<VertexId> vertices;   ///< two tips, or the four corners
  std::vector<Edge> across;         ///< from jamb to jamb: what would close it, of which two are
                                    ///< parallel sides of a wall's opening
  std::vector<SegmentId> segments;  ///< those that end there, ascending
};

/// How to diagnose.
struct DiagnoseOptions {
  /// The search distance; by default the longer side of the drawing's `extent` / 1000. Requires:
  /// not negative.
  std::optional<Rational> within = std::nullopt;
  std::size_t most_listed = 1000;  ///< of each kind
  /// How wide doors are; by default from the longer side of the `extent` / 100 to / 10.
  std::optional<Range> doors = std::nullopt;
};

/// What a tolerance would do.
struct ToleranceEffect {
  double tolerance = 0;
  std::size_t mended = 0;      ///< defects whose proposed tolerance is no larger
  bool spares_detail = false;  ///< whether all edges that are part of no defect are longer
};

struct Diagnosis {
  Rational within;              ///< the search distance
  std::vector<Defect> defects;  ///< by kind; most relevant first (see `diagnose`)
  /// Per kind, how many there are; at most `most_listed` of them are in `defects`.
  std::array<std::size_t, kDefectKinds> found{};
  std::size_t tips = 0;           ///< vertices of degree 1
  std::size_t shared_sides = 0;   ///< as in Repetitions
  std::vector<Opening> openings;  ///< by their vertices
  /// The shortest edge that is part of no defect, squared; none without such an edge.
  std::optional<Rational> squared_detail;
  /// Of the proposed tolerances the largest one of each decade, and the largest that spares all
  /// detail; ascending. The last one mends all that can be mended.
  std::vector<ToleranceEffect> tolerances;
  /// Vertices around which so much is near that the search was cut short: defects there can be
  /// missing. 0 unless the search distance is far too large for the drawing.
  std::size_t cut_short = 0;

  std::size_t count(DefectKind kind) const { return found[static_cast<std::size_t>(kind)]; }
};

/// How often the drawing draws the same twice.
struct Repetitions {
  std::size_t duplicates =
      0;                     ///< segments with the two ends of an earlier one, in either direction
  std::size_t overlaps = 0;  ///< pairs of different collinear segments that share more than a point
  /// Neither: pairs of segments that share more than a point as sides of two closed shapes that lie
  /// on the two sides of it (`Ring`s), and nothing else is there.
  std::size_t shared_sides = 0;
};
/// **Exact**. Requires: the complex is `arrange(input)`. Cost: O(n log n), and linear in the
/// complex.
Repetitions repetitions(const SegmentSet& input, const ExactComplex& complex);

/// The defects of a drawing, found in its exact arrangement. **Exact**, but for which near places a
/// short way along the edges explains (**heuristic**: lengths of ways in doubles, at most four
/// times the distance). Requires: the complex is `arrange(input)`. Order: by kind; gaps and
/// undershoots that leave most open first; repetitions and bridges longest first, all others
/// smallest first (the smaller, the surer it is an accident); then by place. Does not depend on
/// order, direction or repetition of the segments, SegmentIds aside. Cost: O(n log n) for a search
/// distance not larger than the drawing's features; a larger one costs up to some thousand
/// operations a vertex. Throws: Error BadInput for a negative search distance.
Diagnosis diagnose(const SegmentSet& input, const ExactComplex& complex,
                   const DiagnoseOptions& options = {});

/// Positions in Diagnosis::defects, those that matter most first: gaps and undershoots that leave a
/// face open, the largest first; rings that are not valid; other ends that do not meet; what is
/// near without meeting; what is drawn twice; what dangles.
std::vector<std::size_t> by_effect(const Diagnosis& diagnosis);

}  // namespace plumbline
