#pragma once

#include <map>

#include "compare/groups.hpp"
#include "compare/sides.hpp"

// The steps of the comparison, in order. Each gives its correspondence and its findings. Findings
// of vertices and edges are numbered on from `first_number`, so that later steps can name them as
// causes.
namespace plumbline::compare_steps {

/// How much of each finding is wanted.
enum class Detail {
  Full,
  CellsOnly,  ///< which cells are in findings: no distances, areas and places but of lone vertices
  /// Of faces only which exact ones are in findings, of holes nothing, of vertices and edges all.
  ExactCellsOnly,
};

/// Numbers of findings by cell; 0: the cell is in no finding.
using Numbers = std::vector<std::size_t>;

/// The broken invariants of the float complex, or those of its vertices and edges, as findings.
std::vector<Finding> invalidities(const Sides& sides, Compared compared);

/// Where the faces of an invalid float complex overlap or leave gaps wider than the tolerance, with
/// exact areas: Invalid, of the invariant Area. Only where cycles or edges are wrong (the wrong
/// nesting of sound cycles is named by itself). Names the invalidities that it follows from, which
/// are numbered from 1. Cost: that of an arrangement of all float edges.
std::vector<Finding> miscoverings(const Sides& sides, const std::vector<Finding>& invalidities);

struct VertexMatch {
  Both<std::vector<VertexId>> match;  ///< one to one, moved ones too; invalid where there is none
  /// The match, else the nearest vertex of the other side within the tolerance, else invalid.
  Both<std::vector<VertexId>> image;
  std::size_t moved_count = 0;  ///< of the matches, how many lie beyond the tolerance
  Rational largest_squared;     ///< distance of the other matches
  std::vector<Finding> findings;
  Both<Numbers> number;
};
/// Pairs of vertices within the tolerance are matched one to one, nearest pairs first (so each is
/// the other's nearest among those left), ties by index. Of the others, those that correspond by
/// their edges are Moved (`moved_vertices`); what is left over is Merged or Split if there is a
/// vertex of the other side within the tolerance, else Missing or Extra. Cost: O(n log n), with at
/// most NearVertices::kMaxNeighbours candidates a vertex.
VertexMatch match_vertices(const Sides& sides, std::size_t first_number, Detail detail);

struct EdgeMatch {
  Both<std::vector<EdgeId>> match;      ///< one to one; invalid where there is none
  Both<std::vector<HalfedgeId>> along;  ///< the match, from the tail to the head of the edge here
  Both<std::map<EdgeId, std::vector<HalfedgeId>>> other_image;  ///< of edges without a match
  /// What each edge is on the other side, from its tail to its head: halfedges there; nothing if it
  /// is a vertex there or part of an edge listed with another one; nullopt: missing.
  std::optional<std::span<const HalfedgeId>> image(Side side, EdgeId e) const;
  std::vector<Finding> findings;
  Both<Numbers> number;
};
/// Edges are matched if their ends are (one to one, or by their images). The others are collapsed
/// or parallel (Merged, Split), lie along a chain of edges of the other side (Split, Merged), or
/// are Missing or Extra. Cost: near-linear; a chain costs the edges within the tolerance of it.
EdgeMatch match_edges(const Sides& sides, const VertexMatch& vertices, std::size_t first_number,
                      Detail detail);

/// Cycles of each side, walked through the edge match, against those of the other side.
struct CycleMatch {
  Both<std::vector<CycleId>> same;      ///< per cycle: what it is on the other side, or invalid
  std::vector<bool> is_one_to_one;      ///< per exact cycle: ... and all its edges are matched
  Both<std::vector<CycleId>> cycle_of;  ///< per halfedge; invalid where it is in no cycle
};
CycleMatch match_cycles(const Sides& sides, const EdgeMatch& edges);

struct FaceMatch {
  std::size_t same = 0;             ///< pairs with the same outer boundary, the unbounded one too
  Both<std::vector<FaceId>> match;  ///< one to one, with the same boundary or reshaped
  /// Which faces correspond at all, also where several are one: equal numbers on both sides. 0 is
  /// the unbounded faces; kNoGroup: Missing or Extra.
  Both<std::vector<std::size_t>> group;
  std::vector<Finding> findings;
};
inline constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);
/// Faces are matched by equal outer boundaries; the rest corresponds by boundaries that differ only
/// by merged or split cells, and then by which face of the other side covers most of it, among
/// those left over (`overlay`). Cost: O(E log E), an overlay of the boundaries of the faces left
/// over after the first step, and for each of the last ones the edges that a horizontal line
/// through its interior point meets.
FaceMatch match_faces(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
                      const CycleMatch& cycles, bool float_is_valid, Detail detail);

/// Holes and isolated vertices: Missing, Extra, Merged, Split, Reshaped or in the wrong face. Holes
/// of the unbounded face (the outlines of components) are reported only as WrongParent.
std::vector<Finding> nesting(const Sides& sides, const VertexMatch& vertices,
                             const EdgeMatch& edges, const CycleMatch& cycles,
                             const FaceMatch& faces);

/// Makes the earlier findings of these numbers (zeros and repetitions left out) the reason of a
/// finding: its message ends in ", because of findings 3 and 7".
void add_causes(Finding& finding, Numbers numbers);

}  // namespace plumbline::compare_steps
