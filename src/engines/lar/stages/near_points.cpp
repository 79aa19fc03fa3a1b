#include "engines/lar/stages/near_points.hpp"

#include <nanoflann.hpp>

#include "engines/lar/stages/points.hpp"

namespace plumbline::lar {
namespace {

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
using Index = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 2, std::uint32_t>;

/// What the search reports to.
struct Visitor {
  std::span<const PointD> points;
  std::size_t point;
  double radius;
  const std::function<void(std::size_t)>& visit;

  bool full() const { return true; }
  /// A little more than the squared radius: the tree adds up its distances with rounding.
  double worstDist() const { return radius * radius * (1 + 1e-6); }
  bool addPoint(double, std::uint32_t other) {
    if (near(points[point], points[other], radius)) visit(other);
    return true;
  }
};

}  // namespace

struct NearPoints::Tree {
  explicit Tree(std::span<const PointD> points) : cloud{points}, index(2, cloud) {}
  Cloud cloud;
  Index index;
};

NearPoints::NearPoints(std::span<const PointD> points, double radius)
    : points_(points), radius_(radius) {
  if (!points.empty()) tree_ = std::make_unique<Tree>(points);  // nanoflann refuses no points
}

NearPoints::~NearPoints() = default;

void NearPoints::for_each(std::size_t i, const std::function<void(std::size_t)>& visit) const {
  Visitor visitor{points_, i, radius_, visit};
  const double query[2] = {points_[i].x, points_[i].y};
  tree_->index.findNeighbors(visitor, query, nanoflann::SearchParams());
}

}  // namespace plumbline::lar
