#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// Both engines are exact and return the same complex, member by member.
enum class ExactEngine {
  Cgal,    ///< the reference: CGAL::Arrangement_2 over the exact-constructions kernel, aggregated
           ///< insertion (Wein, Berberich, Fogel, Halperin, Hemmer, Salzman, Zukerman: CGAL manual)
  Bucket,  ///< our own: LAR's independent buckets (inters, 2.1) with exact predicates and implicit
           ///< vertices; faster
};

/// How to arrange; nothing here changes the result. The engine Cgal uses one thread and heeds
/// neither.
struct ArrangeOptions {
  std::size_t threads = 0;  ///< at most so many (and 1024); 0: as many as there are cores
  /// Told now and then, in the calling thread, which part of the work is done (from 0 to 1); the
  /// work ends with Error Cancelled where it returns false.
  std::function<bool(double)> progress;
};

/// The arrangement of segments and isolated points as the bucket engine computes it. **Exact**,
/// with implicit vertices: where two segments cross is known, coordinates are computed when asked
/// for. Numbering depends on the input's order, not on the number of threads; `complex` gives the
/// canonical one. Halfedge 2 e runs along edge e, whose tail is lexicographically first.
/// Cost: O((n + K) log n) expected for n segments with K crossings, where segments are spread or
/// bundled so that a bucket can tell them apart; a peak of about 100 bytes per edge, of which half
/// stays. Numbers of any kind cost about the same: doubles decide what they can, and integers the
/// rest, of 30 or 124 bits where there is a common grid. More: features smaller than 2^-38 of the
/// lines they are made of, or 2^-46 of their distance from the middle, are compared pair by pair.
class Arrangement {
 public:
  /// Throws: Error Limit for a coordinate beyond kMaxCoordinateBits and for 2^31 or more ends and
  /// crossings; Cancelled.
  explicit Arrangement(const SegmentSet& input, const ArrangeOptions& options = {});
  Arrangement(Arrangement&&) noexcept;
  Arrangement& operator=(Arrangement&&) noexcept;
  ~Arrangement();

  std::size_t vertex_count() const;
  std::size_t edge_count() const;
  std::size_t face_count() const;  ///< with the unbounded face, which is face 0
  std::size_t component_count() const;
  std::size_t cycle_count() const;

  Edge edge(EdgeId e) const;
  HalfedgeId next(HalfedgeId h) const;  ///< along the cycle on its left
  CycleId cycle(HalfedgeId h) const;
  HalfedgeId first_halfedge(CycleId c) const;
  FaceId face(CycleId c) const;
  CycleId outer_boundary(FaceId f) const;  ///< none for the unbounded face
  std::span<const CycleId> holes(FaceId f) const;
  std::span<const VertexId> isolated_vertices(FaceId f) const;
  /// All input segments that cover an edge, ascending. Cost: O(k) for k segments that overlap
  /// there.
  std::vector<SegmentId> sources(EdgeId e) const;

  /// Coordinates of a vertex. **Exact**. Cost: some products and greatest common divisors.
  Point point(VertexId v) const;
  /// Coordinates of a vertex, correctly **rounded** to the nearest doubles. Cost: as `point`.
  PointD nearest(VertexId v) const;

  /// The same as an exact complex in canonical order. Cost: O(n log n); a third of a microsecond a
  /// vertex where coordinates are decimals of some 11 digits, some microseconds for other
  /// rationals; the progress callback is not told of it.
  ExactComplex complex() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The arrangement of the segments and isolated points: the subdivision of the plane that they
/// induce, in canonical order, each edge with all segments that cover it. **Exact**.
/// Degenerate: collinear overlaps, duplicates, many segments through one point, touching ends are
/// all resolved; empty input gives the unbounded face alone.
/// Order: canonical; does not depend on the order or direction of the segments (SegmentIds in
/// `edge_sources` aside). Cost: O((n + K) log n) exact operations for K crossings.
/// With ExactEngine::Cgal, overlaps of k collinear segments in one place cost O(k^3); equal
/// segments count once. Throws: Error Limit for a coordinate beyond kMaxCoordinateBits
/// (`SegmentSet::add` refuses it).
ExactComplex arrange(const SegmentSet& input, ExactEngine engine = ExactEngine::Bucket,
                     const ArrangeOptions& options = {});

}  // namespace plumbline
