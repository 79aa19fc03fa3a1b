#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::compare_steps {

/// Labels and how often each winds around a place, ascending by label; those that wind 0 times are
/// left out.
using Windings = std::vector<std::pair<std::size_t, int>>;

/// A piece of a label's boundary: who crosses it from right to left enters the label.
struct BoundaryPiece {
  Point a, b;
  std::size_t label;
  EdgeId edge;  ///< where it comes from
};
/// Adds the boundary of a face, under this label.
void add_boundary(std::vector<BoundaryPiece>& pieces, const ExactComplex& complex, FaceId f,
                  std::size_t label);

/// Whether `overlaid` gives something: not for coordinates beyond the limit of `arrange`, and not
/// for more than kMostTinyPieces pieces shorter than 2^-24 of the extent.
inline constexpr std::size_t kMostTinyPieces = 2000;
bool can_be_overlaid(const std::vector<BoundaryPiece>& pieces);
/// Whether too many pieces are that short. Ends are rounded, two successive ones are a piece.
bool are_crowded(std::span<const PointD> ends);

/// The arrangement of all pieces and the windings in each of its faces.
struct Overlaid {
  ExactComplex complex;            ///< `edge_sources`: numbers of pieces
  std::vector<Windings> windings;  ///< per face of the complex
};

/// Overlays boundaries, which may cross and overlap each other. **Exact**. Far outside, the
/// windings are those of `outside`. Degenerate: pieces without length are left out; where the
/// pieces of a label are no closed curves, its windings depend on the way on which the sums are
/// made (breadth first, in canonical order). Nothing for what can't be overlaid: `arrange` would
/// compare tiny pieces each with each. Cost: that of `arrange`, and the labels around each face.
std::optional<Overlaid> overlaid(const std::vector<BoundaryPiece>& pieces, Windings outside);

}  // namespace plumbline::compare_steps
