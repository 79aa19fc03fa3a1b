#pragma once

#include <cstdint>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::rings {

/// A ring as it goes along the edges of the complex: edge i leads from vertex i to the next one; a
/// closed ring has as many edges as vertices, others one less.
struct Walk {
  std::size_t ring = 0;  ///< index into SegmentSet::rings
  RingRole role = RingRole::Polygon;
  bool is_closed = true;
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
};

/// Finds the edges of rings.
class Walks {
 public:
  /// Keeps references.
  Walks(const SegmentSet& input, const ExactComplex& complex);
  Walk of(std::size_t ring) const;

 private:
  const SegmentSet& input_;
  const ExactComplex& complex_;
  std::vector<std::uint32_t> begin_;  ///< per segment, into `edges_`
  std::vector<EdgeId> edges_;         ///< of the segments of rings, each in ascending order
};

}  // namespace plumbline::rings
