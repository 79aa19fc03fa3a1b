#pragma once

#include <optional>

#include "plumbline/complex.hpp"

namespace plumbline {

/// A vertical scan line just right of x: which edges it meets, and in which order. All **exact**.
/// "Just right of" (x + epsilon) makes every decision general: no vertex lies on the line.
class ScanLine {
 public:
  ScanLine(const ExactComplex& complex, const Rational& x) : complex_(complex), x_(x) {}

  /// Whether the line just right of x meets edge e.
  bool meets(EdgeId e) const;
  /// Whether e, which the line meets, passes strictly below p. Requires: p.x == x.
  bool passes_below(EdgeId e, const Point& p) const;
  /// Whether e is above f on the line. Requires: it meets both, and they do not cross there.
  bool above(EdgeId e, EdgeId f) const;

 private:
  Rational height(EdgeId e) const;
  Rational slope(EdgeId e) const;

  const ExactComplex& complex_;
  const Rational& x_;
};

/// The face just above edge e (halfedges from tail to head run rightwards), or the unbounded face.
FaceId face_above(const Incidences& complex, std::optional<EdgeId> e);

}  // namespace plumbline
