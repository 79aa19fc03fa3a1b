// Proposes vertices near a point by a KD-tree on doubles, confirms them by exact distances.

#include "crosscheck/near_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

namespace plumbline::matching {
namespace {

// Proposals for the nearest vertex: rounding can disturb the order of those that coincide in
// doubles, of which more than this many at one place are not told apart.
constexpr std::size_t kNearestProposals = 8;
// A rounded coordinate is off by at most half an ulp of the largest, 2^-53 of it, so a distance of
// two rounded points by less than 2^-51 of it; the rest is room for rounding in the tree.
constexpr double kRelativeSlack = 0x1p-48;

double finite(double value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(value, -kLargest, kLargest);
}

}  // namespace

// Coordinates are scaled by a power of two to at most 1, so that squares can't overflow.
struct NearVertices::Tree {
  using Metric = nanoflann::L2_Simple_Adaptor<double, Tree>;
  using Index = nanoflann::KDTreeSingleIndexAdaptor<Metric, Tree, 2>;

  int exponent = 0;
  std::vector<PointD> points;
  std::unique_ptr<Index> index;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? points[i].x : points[i].y;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  PointD scaled(const Point& p) const {
    const PointD rounded = nearest(p);
    return {std::ldexp(finite(rounded.x), -exponent), std::ldexp(finite(rounded.y), -exponent)};
  }

  std::vector<std::size_t> query(const PointD& p, std::size_t count, double radius) const {
    std::vector<std::size_t> ids(count);
    std::vector<double> distances(count);
    nanoflann::KNNResultSet<double> result(count);
    result.init(ids.data(), distances.data());
    distances[count - 1] = radius * radius;  // the set takes only what is nearer than its last
    index->findNeighbors(result, &p.x, nanoflann::SearchParams());
    ids.resize(result.size());
    return ids;
  }
};

NearVertices::NearVertices(const ExactComplex& complex)
    : complex_(complex), tree_(std::make_unique<Tree>()) {
  double largest = 0;
  for (const Point& p : complex.vertices) {
    const PointD rounded = nearest(p);
    largest = std::max({largest, std::abs(finite(rounded.x)), std::abs(finite(rounded.y))});
  }
  tree_->exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  for (const Point& p : complex.vertices) tree_->points.push_back(tree_->scaled(p));
  if (!complex.vertices.empty()) tree_->index = std::make_unique<Tree::Index>(2, *tree_);
}

NearVertices::~NearVertices() = default;
NearVertices::NearVertices(NearVertices&&) noexcept = default;

std::vector<Near> NearVertices::confirmed(const Point& p,
                                          const std::vector<std::size_t>& proposals) const {
  std::vector<Near> result;
  for (const std::size_t i : proposals)
    result.push_back({VertexId(i), squared_distance(p, complex_.vertices[i])});
  std::sort(result.begin(), result.end(), [](const Near& a, const Near& b) {
    const int by_distance = cmp(a.squared_distance, b.squared_distance);
    return by_distance != 0 ? by_distance < 0 : a.vertex < b.vertex;
  });
  return result;
}

std::vector<Near> NearVertices::within(const Point& p, double tolerance,
                                       const Rational& squared_tolerance) const {
  if (!tree_->index) return {};
  const PointD q = tree_->scaled(p);
  const double magnitude = std::max({1.0, std::abs(q.x), std::abs(q.y)});
  const double radius =
      std::ldexp(tolerance, -tree_->exponent) * (1 + kRelativeSlack) + magnitude * kRelativeSlack;
  std::vector<Near> result = confirmed(p, tree_->query(q, kMaxNeighbours, radius));
  const auto is_far = [&](const Near& near) { return near.squared_distance > squared_tolerance; };
  result.erase(std::find_if(result.begin(), result.end(), is_far), result.end());
  return result;
}

std::optional<Near> NearVertices::nearest_to(const Point& p) const {
  if (!tree_->index) return std::nullopt;
  const std::vector<Near> found = confirmed(
      p, tree_->query(tree_->scaled(p), kNearestProposals, std::numeric_limits<double>::max()));
  if (found.empty()) return std::nullopt;
  return found.front();
}

}  // namespace plumbline::matching
