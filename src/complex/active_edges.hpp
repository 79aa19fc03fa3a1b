#pragma once

#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// Least vertex of each component. Components are numbered by it, so they come in scan order.
std::vector<VertexId> least_vertices(const ExactComplex& complex);

/// The edges that a vertical scan line may meet, with the heights that nearest doubles of their
/// ends bound. Rounding is monotone: what is lower in doubles is not higher. Requires: canonical
/// order; the complex need not be valid.
class ActiveEdges {
 public:
  /// Keeps a reference to the complex.
  explicit ActiveEdges(const ExactComplex& complex);

  /// Takes in the edges that begin at or left of x, drops those that end there. Requires: called
  /// with ascending x.
  void advance(const Rational& x);
  /// The highest edge below vertex v just right of it. Requires: advance(x of v) was called.
  std::optional<EdgeId> below(VertexId v) const;

 private:
  struct Item {
    EdgeId edge;
    double low, high;
  };
  const ExactComplex& c_;
  std::vector<double> y_;  ///< per vertex
  std::vector<Item> active_;
  std::size_t next_ = 0;
};

}  // namespace plumbline
