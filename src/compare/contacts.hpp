#pragma once

#include "compare/common_points.hpp"

namespace plumbline::compare_steps {

/// Where an edge meets the other side: in a vertex there, else inside an edge there.
struct Contact {
  static constexpr std::size_t kCrossing = static_cast<std::size_t>(-1);

  Point at;
  std::size_t point = kCrossing;  ///< the number of that point, where it is a vertex of a side
  VertexId vertex;                ///< of the other side; invalid inside an edge
  EdgeId edge;                    ///< of the other side; invalid at a vertex
};
/// Per edge of a side (nothing for edges that were not asked for) its contacts, ends included, from
/// the tail to the head, each once.
using Contacts = std::vector<std::vector<Contact>>;

/// The contacts of these edges of the two sides with each other. **Exact**. Requires: on each side
/// edges meet in common ends only. Cost: O(n log n) and the pairs of edges that come near each
/// other.
Both<Contacts> contacts(const Sides& sides, const CommonPoints& points,
                        const Both<std::vector<EdgeId>>& edges);

}  // namespace plumbline::compare_steps
