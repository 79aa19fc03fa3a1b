#pragma once

#include "compare/sides.hpp"

namespace plumbline::compare_steps {

/// A part of the plane and which of the overlaid faces cover it, on each side, ascending.
struct Region {
  Rational area;
  Both<std::vector<std::size_t>> faces;
};

/// Whether the boundaries of these faces can be overlaid; then those of some of them can.
bool can_be_overlaid(const Sides& sides, const Both<std::vector<std::size_t>>& faces);

/// The parts that bounded faces of the two sides cover. **Exact**: a face covers what its boundary
/// winds around other than 0 times, so faces of an invalid complex may overlap. Nothing where
/// boundaries can't be overlaid. Cost: that of `face_overlaps` where the float side is valid, else
/// that of an arrangement of the boundaries.
std::optional<std::vector<Region>> overlay(const Sides& sides,
                                           const Both<std::vector<std::size_t>>& faces,
                                           bool float_is_valid);

/// Exact areas by which the faces of the two sides overlap.
class Overlaps {
 public:
  explicit Overlaps(std::vector<Region> regions);

  /// Pairs of an exact and a float face of which one covers most of the other, or more of it than
  /// any other face. Ascending.
  std::vector<std::pair<std::size_t, std::size_t>> pairs(
      const Both<std::vector<std::size_t>>& faces) const;
  /// The area that faces of only one of the sides cover.
  Rational symmetric_difference(const Both<std::vector<std::size_t>>& faces) const;

 private:
  std::vector<std::size_t> regions_of(const Both<std::vector<std::size_t>>& faces) const;

  std::vector<Region> regions_;
  Both<std::vector<std::pair<std::size_t, std::size_t>>> region_of_face_;  ///< sorted
};

}  // namespace plumbline::compare_steps
