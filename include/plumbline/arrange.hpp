#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// Both engines are exact and return the same complex, member by member.
enum class Engine {
  Cgal,    ///< the reference: CGAL::Arrangement_2 over the exact-constructions kernel, aggregated
           ///< insertion (Wein, Berberich, Fogel, Halperin, Hemmer, Salzman, Zukerman: CGAL manual)
  Bucket,  ///< our own: LAR's independent buckets (inters, 2.1) with exact predicates and implicit
           ///< vertices; faster
};

/// The arrangement of the segments and isolated points: the subdivision of the plane that they
/// induce, in canonical order, each edge with all segments that cover it. **Exact**.
/// Degenerate: collinear overlaps, duplicates, many segments through one point, touching ends are
/// all resolved; empty input gives the unbounded face alone.
/// Order: canonical; does not depend on the order or direction of the segments (SegmentIds in
/// `edge_sources` aside). Cost: O((n + K) log n) exact operations for K crossings.
/// With Engine::Cgal, overlaps of k collinear segments in one place cost O(k^3); equal segments
/// count once.
/// Throws: Error Limit for a coordinate beyond kMaxCoordinateBits (`SegmentSet::add` refuses it).
ExactComplex arrange(const SegmentSet& input, Engine engine = Engine::Bucket);

}  // namespace plumbline
