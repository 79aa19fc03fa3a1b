#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumbline/compare.hpp"
#include "plumbline/engine.hpp"

namespace plumbline {

/// What became of exact faces in an answer.
enum class FaceChange {
  Lost,      ///< no face of the answer corresponds to it
  Opened,    ///< the same, of a face too wide to have collapsed whose place is outside now
  Joined,    ///< several became one
  Parted,    ///< one became several
  Closed,    ///< the answer has a face where the drawing has none
  Added,     ///< the answer has a face too many within another one
  Reshaped,  ///< it has another boundary
};
std::string to_text(FaceChange change);

struct ChangedFaces {
  FaceChange change = FaceChange::Lost;
  std::size_t finding = 0;    ///< the number of the finding that says so
  std::vector<double> areas;  ///< of the exact faces; of Closed and Added of the answer's
  /// In dispute, 0 where that is not known; of Joined and Parted also what changed hands: all of
  /// the faces, or of the parts, but the largest.
  double area = 0;
};

/// Findings that hang together: one event in one place.
struct FindingGroup {
  std::vector<std::size_t> findings;  ///< their numbers, ascending
  std::size_t lead = 0;               ///< the number of the one to look at first
  PointD low, high;                   ///< the box of the cells that they are about
  std::vector<ChangedFaces> faces;    ///< largest area in dispute first
  double area = 0;                    ///< in dispute, of all of them
  bool is_own = false;                ///< it is the drawing's own: stage kDrawing
};

/// Groups the findings of a comparison, each in one group. Findings about vertices and edges hang
/// together where they have a cell or a place in common, an edge ends in a vertex that has one, one
/// names the other as its reason, an extra edge begins where a missing one does, or an edge joins
/// two moved vertices; a vertex without finding ends a group. A face or hole belongs to the group
/// that most of its reasons are in. Wrong cycles and faces of an invalid complex are one group; all
/// is one where most of the answer lies elsewhere. What is the file's own, what rounding to doubles
/// made and what the engine made are groups apart where causes are given (one for each finding, or
/// none). Ordered: an invalid complex first, then by the area of faces in dispute, by the number of
/// findings, by the first one; groups of the file's own last. Places are compared as nearest
/// doubles, extra and missing edges within the tolerance; areas are rounded. **Requires**: the
/// comparison of these two complexes. Cost: O(n log n), and exact areas of the faces that findings
/// name.
std::vector<FindingGroup> group_findings(const Comparison& comparison,
                                         const std::vector<Cause>& causes,
                                         const ExactComplex& exact_complex,
                                         const FloatComplex& answer);

}  // namespace plumbline
