// Both minima are found by looking only at pairs within a window as wide as the best distance so
// far. Windows are measured in doubles and widened beyond their rounding error; distances are
// exact.

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// Upper bound of a distance, given its exact square, on coordinates of absolute value up to
/// `extent`. Nearest doubles of two coordinates differ from their exact difference by at most 4
/// half-ulps of the extent; the relative margin covers the square root, the last term
/// coordinates that underflow.
double window(const Rational& squared, double extent) {
  constexpr double kRelative = 1 + 8 * std::numeric_limits<double>::epsilon();
  return nearest_sqrt(squared) * kRelative + 4 * std::numeric_limits<double>::epsilon() * extent +
         8 * std::numeric_limits<double>::denorm_min();
}

class Search {
 public:
  explicit Search(const ExactComplex& complex) : c_(complex) {
    for (const Point& p : c_.vertices) {
      points_.push_back(nearest(p));
      extent_ = std::max({extent_, std::abs(points_.back().x), std::abs(points_.back().y)});
    }
  }

  void vertex_vertex(FeatureSize& size) const {
    for (std::size_t e = 0; e < c_.edge_count(); ++e)
      offer(size, c_.edges[e].tail, c_.edges[e].head);
    double reach = window(size.squared_vertex_vertex, extent_);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      for (std::size_t w = v + 1; w < points_.size() && points_[w].x - points_[v].x <= reach; ++w) {
        if (std::abs(points_[w].y - points_[v].y) > reach) continue;
        if (offer(size, VertexId(v), VertexId(w))) {
          reach = window(size.squared_vertex_vertex, extent_);
        }
      }
    }
  }

  void vertex_edge(FeatureSize& size) const {
    // The distance of an edge from the ends of its neighbours is at most the neighbour's length, so
    // the least vertex-vertex distance need not be an upper bound; start from the whole extent.
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      const PointD &a = points_[c_.edges[e].tail], &b = points_[c_.edges[e].head];
      const auto first = std::partition_point(points_.begin(), points_.end(),
                                              [&](const PointD& p) { return p.x < a.x - reach; });
      for (auto p = first; p != points_.end() && p->x <= b.x + reach; ++p) {
        if (p->y < std::min(a.y, b.y) - reach || p->y > std::max(a.y, b.y) + reach) continue;
        if (offer(size, VertexId(static_cast<std::size_t>(p - points_.begin())), e)) {
          reach = window(size.squared_vertex_edge, extent_);
        }
      }
    }
  }

 private:
  bool offer(FeatureSize& size, VertexId v, VertexId w) const {
    const Rational squared = squared_distance(c_.vertices[v], c_.vertices[w]);
    if (size.v.valid() && squared >= size.squared_vertex_vertex) return false;
    size.squared_vertex_vertex = squared;
    size.v = v;
    size.w = w;
    return true;
  }
  bool offer(FeatureSize& size, VertexId v, EdgeId e) const {
    if (v == c_.edges[e].tail || v == c_.edges[e].head) return false;
    const Rational squared = squared_distance(c_.vertices[v], c_.vertices[c_.edges[e].tail],
                                              c_.vertices[c_.edges[e].head]);
    if (size.edge.valid() && squared >= size.squared_vertex_edge) return false;
    size.squared_vertex_edge = squared;
    size.vertex = v;
    size.edge = e;
    return true;
  }

  const ExactComplex& c_;
  std::vector<PointD> points_;
  double extent_ = 0;
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
