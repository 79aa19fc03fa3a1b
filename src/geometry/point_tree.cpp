#include "geometry/point_tree.hpp"

#include <cstdint>
#include <nanoflann.hpp>

#include "geometry/point_d.hpp"

namespace plumbline {
namespace {

/// What a search within a radius reports to.
struct Visitor {
  std::span<const PointD> points;
  const PointD& place;
  double radius;
  const std::function<void(std::size_t)>& visit;

  bool full() const { return true; }
  /// A little more than the squared radius: the tree adds up its distances with rounding.
  double worstDist() const { return radius * radius * (1 + 1e-6); }
  bool addPoint(double, std::uint32_t i) {
    if (squared_distance(place, points[i]) <= radius * radius) visit(i);
    return true;
  }
};

}  // namespace

struct PointTree::Tree {
  /// The points as nanoflann wants to see them.
  struct Cloud {
    std::span<const PointD> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return axis == 0 ? points[i].x : points[i].y;
    }
    template <class BoundingBox>
    bool kdtree_get_bbox(BoundingBox&) const {
      return false;
    }
  };
  using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud, double, std::uint32_t>;
  using KdTree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 2, std::uint32_t>;

  explicit Tree(std::span<const PointD> points) : cloud{points}, index(2, cloud) {}
  Cloud cloud;
  KdTree index;
};

PointTree::PointTree(std::span<const PointD> points) {
  if (!points.empty()) tree_ = std::make_unique<Tree>(points);  // nanoflann refuses no points
}

PointTree::~PointTree() = default;

void PointTree::for_each_near(const PointD& p, double radius,
                              const std::function<void(std::size_t)>& visit) const {
  if (!tree_) return;
  Visitor visitor{tree_->cloud.points, p, radius, visit};
  tree_->index.findNeighbors(visitor, &p.x, nanoflann::SearchParams());
}

std::vector<std::size_t> PointTree::nearest(const PointD& p, std::size_t count,
                                            double radius) const {
  if (!tree_) return {};
  std::vector<std::uint32_t> ids(count);
  std::vector<double> distances(count);
  nanoflann::KNNResultSet<double, std::uint32_t> result(count);
  result.init(ids.data(), distances.data());
  distances[count - 1] = radius * radius;  // the set takes only what is nearer than its last
  tree_->index.findNeighbors(result, &p.x, nanoflann::SearchParams());
  return {ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(result.size())};
}

}  // namespace plumbline
