#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/filtered_points.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::compare_steps {

/// A vertex and its exact squared distance from the point asked for.
struct Near {
  VertexId vertex;
  Rational squared_distance;
};

/// Finds the vertices of a complex near a point. A KD-tree on rounded coordinates proposes, exact
/// distances decide. Cost: O(n log n) for the first query, O(log n) for another.
class NearVertices {
 public:
  /// Keeps a reference to the vertices.
  explicit NearVertices(const FilteredPoints& vertices);
  ~NearVertices();
  NearVertices(NearVertices&&) noexcept;

  /// The vertices within `tolerance` of p, nearest first, then by index; of more than
  /// kMaxNeighbours the nearest ones.
  std::vector<Near> within(const Point& p, double tolerance,
                           const Rational& squared_tolerance) const;
  /// The nearest vertex, the least of several; none in a complex without vertices.
  std::optional<Near> nearest_to(const Point& p) const;

  /// Bounds the work where the tolerance is far larger than the drawing's features.
  static constexpr std::size_t kMaxNeighbours = 32;

 private:
  struct Tree;
  std::vector<Near> confirmed(const Point& p, const std::vector<std::size_t>& proposals) const;

  const Tree& tree() const;

  const FilteredPoints& vertices_;
  mutable std::unique_ptr<Tree> tree_;  ///< made when first asked for
};

}  // namespace plumbline::compare_steps
