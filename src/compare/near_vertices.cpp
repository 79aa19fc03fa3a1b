// Proposes vertices near a point by a KD-tree on doubles, confirms them by exact distances where
// rounded ones are too near each other to tell.

#include "compare/near_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/sole_neighbours.hpp"
#include "geometry/point_d.hpp"
#include "geometry/point_tree.hpp"

namespace plumbline::compare_steps {
namespace {

// Proposals for the nearest vertex, of which rounding can disturb the order: first so many, more
// while all of them coincide in doubles; of more than the most at one place some are not looked at.
constexpr std::size_t kNearestProposals = 8, kMostNearestProposals = 512;
// A rough coordinate is off by less than 2^-52 of the largest, so a distance of two rough points by
// less than 2^-50 of it; the rest is room for rounding in the tree.
constexpr double kDistanceSlack = 0x1p-48;

double finite(double value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(value, -kLargest, kLargest);
}

}  // namespace

// Coordinates are scaled by a power of two to at most 1, so that squares can't overflow.
struct NearVertices::Tree {
  int exponent;
  std::vector<PointD> points;
  PointTree index;

  explicit Tree(const FilteredPoints& vertices)
      : exponent(exponent_of(vertices)), points(all_scaled(vertices)), index(points) {}

  PointD scaled(const PointD& p) const {
    return {std::ldexp(finite(p.x), -exponent), std::ldexp(finite(p.y), -exponent)};
  }

 private:
  static int exponent_of(const FilteredPoints& vertices) {
    double largest = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const PointD& p = vertices.rough(v);
      largest = std::max({largest, std::abs(finite(p.x)), std::abs(finite(p.y))});
    }
    return largest > 0 ? std::ilogb(largest) + 1 : 0;
  }
  std::vector<PointD> all_scaled(const FilteredPoints& vertices) const {
    std::vector<PointD> result;
    result.reserve(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) result.push_back(scaled(vertices.rough(v)));
    return result;
  }
};

NearVertices::NearVertices(const FilteredPoints& vertices) : vertices_(vertices) {}
NearVertices::~NearVertices() = default;
NearVertices::NearVertices(NearVertices&&) noexcept = default;

const NearVertices::Tree& NearVertices::tree() const {
  if (!tree_) tree_ = std::make_unique<Tree>(vertices_);
  return *tree_;
}

std::vector<VertexId> NearVertices::proposals(const PointD& rough, double tolerance) const {
  const Tree& tree = this->tree();
  const PointD q = tree.scaled(rough);
  const double magnitude = std::max({1.0, std::abs(q.x), std::abs(q.y)});
  const double radius =
      std::ldexp(tolerance, -tree.exponent) * (1 + kDistanceSlack) + magnitude * kDistanceSlack;
  const std::vector<std::size_t> found = tree.index.nearest(q, kMaxNeighbours, radius);
  return {found.begin(), found.end()};
}

std::vector<Near> NearVertices::nearest_roughly(const FilteredPoints& points, std::size_t p) const {
  const Tree& tree = this->tree();
  const PointD q = tree.scaled(points.rough(p));
  const double slack = distance_slack(points, vertices_);
  std::vector<Near> near;
  for (std::size_t count = kNearestProposals;; count *= 4) {
    near.clear();
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : tree.index.nearest(q, count, std::numeric_limits<double>::max())) {
      near.push_back({VertexId(i), distance(points.rough(p), vertices_.rough(i))});
      least = std::min(least, near.back().distance);
    }
    std::erase_if(near, [&](const Near& one) { return one.distance > least + 2 * slack; });
    if (near.size() < count || count >= kMostNearestProposals) return near;
  }
}

std::optional<Near> NearVertices::nearest_to(const FilteredPoints& points, std::size_t p) const {
  const std::vector<Near> near = nearest_roughly(points, p);
  if (near.empty()) return std::nullopt;
  const auto squared = [&](const Near& one) {
    return squared_distance(points[p], vertices_[one.vertex]);
  };
  Near nearest = near.front();
  for (std::size_t i = 1; i < near.size(); ++i) {
    const int order = cmp(squared(near[i]), squared(nearest));
    if (order < 0 || (order == 0 && near[i].vertex < nearest.vertex)) nearest = near[i];
  }
  return nearest;
}

}  // namespace plumbline::compare_steps
