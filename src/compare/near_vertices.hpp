#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/filtered_points.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::compare_steps {

/// A vertex and its distance from the point asked for, off by at most the slack of both lists.
struct Near {
  VertexId vertex;
  double distance;
};

/// Finds the vertices of a complex near a point. A KD-tree on rounded coordinates proposes, exact
/// distances decide where rounded ones do not. Cost: O(n log n) for the first query, O(log n) for
/// another.
class NearVertices {
 public:
  /// Keeps a reference to the vertices.
  explicit NearVertices(const FilteredPoints& vertices);
  ~NearVertices();
  NearVertices(NearVertices&&) noexcept;

  /// All vertices within `tolerance` of the point, and some that may be a little further away; of
  /// more than kMaxNeighbours the nearest ones. Points are given by their rough coordinates.
  std::vector<VertexId> proposals(const PointD& rough, double tolerance) const;
  /// The vertex nearest to point p, the least of several; none in a complex without vertices.
  std::optional<Near> nearest_to(const FilteredPoints& points, std::size_t p) const;

  /// Bounds the work where the tolerance is far larger than the drawing's features.
  static constexpr std::size_t kMaxNeighbours = 32;

 private:
  struct Tree;
  const Tree& tree() const;
  /// The vertices that may be nearest to point p.
  std::vector<Near> nearest_roughly(const FilteredPoints& points, std::size_t p) const;

  const FilteredPoints& vertices_;
  mutable std::unique_ptr<Tree> tree_;  ///< made when first asked for
};

}  // namespace plumbline::compare_steps
