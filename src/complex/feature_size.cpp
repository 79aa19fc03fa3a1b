// Both minima in two looks: the first finds the least rounded distance, the second decides exactly
// among all pairs that rounding does not tell from it.

#include <limits>

#include "complex/vertex_tree.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

class Search {
 public:
  explicit Search(const ExactComplex& complex) : c_(complex), tree_(complex) {}

  void vertex_vertex(FeatureSize& size) const {
    double reach = std::numeric_limits<double>::infinity();
    for (const Edge& e : c_.edges) reach = std::min(reach, tree_.length(e.tail, e.head));
    for_pairs(reach, [&](VertexId, VertexId, double distance) { reach = distance; });
    reach = tree_.above(tree_.above(reach));
    for_pairs(reach, [&](VertexId v, VertexId w, double) {
      const Rational squared = squared_distance(c_.vertices[v], c_.vertices[w]);
      if (size.v.valid() &&
          (squared > size.squared_vertex_vertex ||
           (squared == size.squared_vertex_vertex && (size.v < v || size.w < w)))) {
        return;
      }
      size.squared_vertex_vertex = squared;
      size.v = v;
      size.w = w;
    });
  }

  void vertex_edge(FeatureSize& size) const {
    double reach = std::numeric_limits<double>::infinity();
    for_edges(reach, [&](VertexId, EdgeId, double distance) { reach = distance; });
    reach = tree_.above(tree_.above(reach));
    for_edges(reach, [&](VertexId v, EdgeId e, double) {
      const Rational squared = squared_distance(c_.vertices[v], c_.vertices[c_.edges[e].tail],
                                                c_.vertices[c_.edges[e].head]);
      if (size.edge.valid() &&
          (squared > size.squared_vertex_edge ||
           (squared == size.squared_vertex_edge && (size.edge < e || size.vertex < v)))) {
        return;
      }
      size.squared_vertex_edge = squared;
      size.vertex = v;
      size.edge = e;
    });
  }

 private:
  /// All pairs of vertices v < w within reach, which may shrink meanwhile.
  template <class Visit>
  void for_pairs(const double& reach, const Visit& visit) const {
    for (std::size_t i = 0; i < c_.vertices.size(); ++i) {
      const VertexId v(i);
      tree_.visit(v, v, reach, [&](VertexId w, double distance) {
        if (v < w) visit(v, w, distance);
      });
    }
  }
  /// All pairs of an edge and a vertex that is not its end.
  template <class Visit>
  void for_edges(const double& reach, const Visit& visit) const {
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const Edge& edge = c_.edges[i];
      tree_.visit(edge.tail, edge.head, reach, [&](VertexId v, double distance) {
        if (v != edge.tail && v != edge.head) visit(v, EdgeId(i), distance);
      });
    }
  }

  const ExactComplex& c_;
  VertexTree tree_;
};

}  // namespace

FeatureSize feature_size(const ExactComplex& complex) {
  ensure(complex.edge_count() > 0, "a feature size is asked of a complex with edges");
  FeatureSize size;
  const Search search(complex);
  search.vertex_vertex(size);
  search.vertex_edge(size);
  return size;
}

}  // namespace plumbline
