#pragma once

#include <optional>
#include <vector>

#include "complex/vertex_tree.hpp"
#include "ladder/quotient.hpp"

namespace plumbline {

/// Two vertices, or a vertex and an edge to be led through it, and how near they are.
struct NearPair {
  Rational squared_distance;
  VertexId vertex;
  VertexId other_vertex;  ///< invalid where an edge is near; greater than `vertex` else
  EdgeId edge;
};

/// The pairs of a complex that the tolerance ladder knows (see `tolerance_ladder`), in windows of
/// ascending distance. To lead an edge through vertices that are merged with its ends changes
/// nothing while it is led through no others. Long edges side by side have very many such pairs,
/// which are therefore left out until then.
class NearPairs {
 public:
  /// Keeps a reference to the complex.
  explicit NearPairs(const ExactComplex& complex);

  /// A radius within which about `count` vertices or edges have a pair, by a sample of them.
  double radius_of(std::size_t count) const;

  /// The next window: all pairs further apart than the last one reached and no further than `end`,
  /// or than a lesser distance where these would be many more than `count`. Ascending by distance,
  /// vertices before edges, then by index; before them, what earlier windows left out and now
  /// matters. Pairs of vertices that the quotient has merged are left out. Nothing where too many
  /// pairs are about as near. Requires: `end` beyond the last window.
  std::optional<std::vector<NearPair>> next(double end, std::size_t count,
                                            const Quotient& quotient);
  /// How far the last window reached, 0 before the first.
  double reached() const { return reached_; }

 private:
  struct Proposal {
    double distance;
    VertexId vertex;
    std::uint32_t other;  ///< vertex or edge
    bool is_edge;
  };
  /// Proposals up to a distance that becomes less where there are too many.
  struct Window {
    double end;
    std::size_t most;  ///< proposals before the window is narrowed
    std::vector<Proposal> proposals;
  };

  template <class Visit>
  void for_vertices_along(EdgeId e, const double& reach, bool without_labels,
                          const Visit& visit) const;
  std::vector<double> nearest_of_vertices() const;
  std::vector<double> nearest_of_edges() const;
  void narrow(Window& window, std::size_t count) const;
  std::optional<Window> propose(double end, std::size_t count, const Quotient& quotient);
  bool is_near_others(EdgeId e, double reach) const;
  void propose_along(EdgeId e, double least, double most, std::vector<Proposal>& proposals) const;
  std::vector<Proposal> left_out_before(const std::vector<Proposal>& proposals);
  bool leads_through(EdgeId e, VertexId v) const;
  std::vector<NearPair> decided(const std::vector<Proposal>& proposals, double beyond,
                                double end) const;

  const ExactComplex& complex_;
  VertexTree tree_;
  std::vector<bool> is_behind_;  ///< per edge, whether pairs of it were left out
  double reached_ = 0;
};

}  // namespace plumbline
