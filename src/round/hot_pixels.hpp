#pragma once

#include <vector>

#include "complex/vertex_tree.hpp"
#include "plumbline/complex.hpp"
#include "round/places.hpp"

namespace plumbline::round_steps {

/// The hot pixels of a complex, those that a vertex lies in, and which edge meets which of them.
/// Lengths are in spacings of the grid: centres are integers, pixels of the unit size. A KD-tree
/// proposes pixels near an edge, exact numbers decide. Cost: O(n log n) to build.
class HotPixels {
 public:
  /// Keeps a reference to the complex.
  HotPixels(const ExactComplex& complex, const Rational& spacing);

  /// Their centres, ascending, and per vertex its own.
  const Places& places() const { return places_; }
  /// Those that the edge meets, from tail to head; the first is that of the tail, the last that
  /// of the head, which may be the same.
  std::vector<VertexId> met_by(const Edge& edge) const;

 private:
  bool is_far(const Edge& edge, VertexId pixel) const;

  const ExactComplex& complex_;
  std::vector<Point> points_;  ///< the vertices, in spacings
  Places places_;
  std::vector<PointD> offsets_;  ///< per vertex, from the centre of its pixel; rounded
  std::vector<PointD> centres_;  ///< of pixels, each coordinate within error_
  double error_ = 0;
  VertexTree tree_;  ///< of the centres
};

}  // namespace plumbline::round_steps
