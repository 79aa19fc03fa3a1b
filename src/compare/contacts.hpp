#pragma once

#include "compare/common_points.hpp"

namespace plumbline::compare_steps {

/// Where an edge meets the other side: in a vertex there, else inside an edge there.
struct Contact {
  std::size_t point;  ///< a number of CommonPoints; those that follow are crossings
  VertexId vertex;    ///< of the other side; invalid inside an edge
  EdgeId edge;        ///< of the other side; invalid at a vertex
};
struct Contacts {
  /// Per edge of each side (nothing for edges that were not asked for), ends included, from the
  /// tail to the head, each once.
  Both<std::vector<std::vector<Contact>>> of_edge;
  std::vector<Point> crossings;

  const Point& place(const CommonPoints& points, const Contact& contact) const {
    return contact.point < points.size() ? points.point(contact.point)
                                         : crossings[contact.point - points.size()];
  }
};

/// The contacts of these edges of the two sides with each other. **Exact**. Requires: on each side
/// edges meet in common ends only. Cost: O(n log n) and the pairs of edges that come near each
/// other.
Contacts contacts(const Sides& sides, const CommonPoints& points,
                  const Both<std::vector<EdgeId>>& edges);

}  // namespace plumbline::compare_steps
