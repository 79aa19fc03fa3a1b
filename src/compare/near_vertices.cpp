// Proposes vertices near a point by a KD-tree on doubles, confirms them by exact distances.

#include "compare/near_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/point_tree.hpp"

namespace plumbline::compare_steps {
namespace {

// Proposals for the nearest vertex: rounding can disturb the order of those that coincide in
// doubles, of which more than this many at one place are not told apart.
constexpr std::size_t kNearestProposals = 8;
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
  PointD scaled(const Point& p) const { return scaled(PointD{p.x.get_d(), p.y.get_d()}); }

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

std::vector<Near> NearVertices::confirmed(const Point& p,
                                          const std::vector<std::size_t>& proposals) const {
  std::vector<Near> result;
  for (const std::size_t i : proposals)
    result.push_back({VertexId(i), squared_distance(p, vertices_[i])});
  std::sort(result.begin(), result.end(), [](const Near& a, const Near& b) {
    const int by_distance = cmp(a.squared_distance, b.squared_distance);
    return by_distance != 0 ? by_distance < 0 : a.vertex < b.vertex;
  });
  return result;
}

std::vector<Near> NearVertices::within(const Point& p, double tolerance,
                                       const Rational& squared_tolerance) const {
  const Tree& tree = this->tree();
  const PointD q = tree.scaled(p);
  const double magnitude = std::max({1.0, std::abs(q.x), std::abs(q.y)});
  const double radius =
      std::ldexp(tolerance, -tree.exponent) * (1 + kDistanceSlack) + magnitude * kDistanceSlack;
  std::vector<Near> result = confirmed(p, tree.index.nearest(q, kMaxNeighbours, radius));
  const auto is_far = [&](const Near& near) { return near.squared_distance > squared_tolerance; };
  result.erase(std::find_if(result.begin(), result.end(), is_far), result.end());
  return result;
}

std::optional<Near> NearVertices::nearest_to(const Point& p) const {
  const Tree& tree = this->tree();
  const std::vector<Near> found = confirmed(
      p, tree.index.nearest(tree.scaled(p), kNearestProposals, std::numeric_limits<double>::max()));
  if (found.empty()) return std::nullopt;
  return found.front();
}

}  // namespace plumbline::compare_steps
