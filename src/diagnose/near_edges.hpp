#pragma once

#include <vector>

#include "diagnose/edge_tree.hpp"
#include "diagnose/line_graph.hpp"

namespace plumbline::diagnose_steps {

/// An edge that may be near a vertex. **Rounded**: off by at most LineGraph::slack.
struct NearEdge {
  EdgeId edge;
  double distance;
  PointD foot;  ///< the nearest point
};

/// The exact distance of a vertex from an edge.
struct Nearest {
  Rational squared_distance;
  VertexId end;  ///< the end of the edge that is nearest; none where its interior is
  Point foot;    ///< the nearest point
};
Nearest nearest_on_edge(const ExactComplex& complex, VertexId v, EdgeId e);

/// Finds the edges near a vertex.
class NearEdges {
 public:
  /// Keeps a reference to the graph.
  NearEdges(const LineGraph& graph, const Rational& within);

  struct Answer {
    std::vector<NearEdge> edges;  ///< nearest first, then by index; none that ends at v
    bool cut_short = false;       ///< whether further ones within the distance were left out
  };
  /// The edges within the distance, up to rounding; of more than kMostEdges those within a
  /// smaller distance.
  Answer near(VertexId v) const;

  /// Bounds the work where the search distance is far larger than the drawing's features.
  static constexpr std::size_t kMostEdges = 256;

 private:
  const LineGraph& graph_;
  EdgeTree tree_;
  double reach_;
};

}  // namespace plumbline::diagnose_steps
