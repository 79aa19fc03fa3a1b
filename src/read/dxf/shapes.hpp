#pragma once

#include "read/dxf/drawn.hpp"
#include "read/dxf/entity.hpp"
#include "read/flatten.hpp"

namespace plumbline::dxf {

/// What the shapes need besides their groups.
class Pen {
 public:
  /// Throws: Error BadInput for a negative tolerance.
  Pen(const ReadOptions& options, const Rational& least_tolerance)
      : angle_bound(options.angle_bound),
        draws_hidden(options.hidden),
        draws_hatches(options.hatches),
        join_curves(options.join_curves),
        flattener_(options, least_tolerance) {}

  bool has_curves() const { return flattener_.has_curves(); }

  const double angle_bound;
  const bool draws_hidden;
  const bool draws_hatches;
  const bool join_curves;

  /// The chords of a curve. Throws: Unusable, Error Limit as the Flattener; Limit also where the
  /// numbers of all curves take more than kMaxEvaluatedWords.
  Chords bezier(std::span<const Point> points, std::span<const Rational> weights);
  Chords ellipse(const Ellipse& ellipse);
  Chords arc(const EllipticArc& arc);

 private:
  Chords spend(Chords chords);

  Flattener flattener_;
  std::size_t words_left_ = kMaxEvaluatedWords;
};

/// A vertex of a polyline and the bulge of what leads from it to the next.
struct Vertex {
  NumberPoint point;
  Number bulge;
};
/// The flag of LWPOLYLINE and POLYLINE that joins the last vertex with the first.
constexpr std::int64_t kClosed = 1;
/// A polyline with arcs, in its own coordinates. A closed one ends exactly where it starts.
/// Degenerate: no closing segment where the last vertex is the first. Throws: Unusable for fewer
/// than two vertices.
DrawnEntity draw_polyline(const std::vector<Vertex>& vertices, bool closed, Plane plane, Pen& pen);

/// Whether entities of this type are drawn by `draw_shape`.
bool is_shape(std::string_view type);
/// LINE, LWPOLYLINE, ARC, CIRCLE, ELLIPSE, SPLINE, 3DFACE, SOLID and TRACE; of all, the projection
/// along z. Requires: is_shape of the type. Throws: Unusable.
DrawnEntity draw_shape(const Entity& entity, Pen& pen);
/// Whether a z coordinate or an elevation of the entity is not 0.
bool has_height(const Entity& entity);

}  // namespace plumbline::dxf
