#include "round/hot_pixels.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_d.hpp"
#include "plumbline/error.hpp"
#include "round/grid.hpp"
#include "round/pixel.hpp"

namespace plumbline::round_steps {
namespace {

constexpr double kExactIntegers = 0x1p53;
// An edge runs within half a diagonal of the segment between the centres of its ends' pixels, and
// the centre of a pixel that it meets is within half a diagonal of the edge. sqrt(2), rounded up.
constexpr double kReach = 1.4143;

std::vector<Point> in_spacings(const PointList& points, const Rational& spacing) {
  const Rational factor = 1 / spacing;
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({p.x * factor, p.y * factor});
  return result;
}

std::vector<Point> centres(const std::vector<Point>& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({nearest_integer(p.x), nearest_integer(p.y)});
  return result;
}

}  // namespace

HotPixels::HotPixels(const ExactComplex& complex, const Rational& spacing)
    : complex_(complex),
      points_(in_spacings(complex.vertices, spacing)),
      places_(distinct(centres(points_))),
      tree_(PointList(places_.points)) {
  offsets_.reserve(points_.size());
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const Point& centre = places_.points[places_.of_vertex[v]];
    offsets_.push_back(
        {Rational(points_[v].x - centre.x).get_d(), Rational(points_[v].y - centre.y).get_d()});
  }
  centres_.reserve(places_.points.size());
  for (const Point& p : places_.points) centres_.push_back({p.x.get_d(), p.y.get_d()});
  const double largest = largest_coordinate(centres_);
  // Doubles hold integers up to 2^53; of a larger one get_d loses less than 2^-52.
  if (largest >= kExactIntegers) error_ = 0x1p-51 * largest;
}

/// Whether rounded numbers already prove that the line of the edge misses the pixel.
bool HotPixels::is_far(const Edge& edge, VertexId pixel) const {
  const PointD &a = centres_[places_.of_vertex[edge.tail]],
               &b = centres_[places_.of_vertex[edge.head]], &c = centres_[pixel],
               &from = offsets_[edge.tail], &to = offsets_[edge.head];
  const double ux = (b.x - a.x) + (to.x - from.x), uy = (b.y - a.y) + (to.y - from.y);
  const double vx = (c.x - a.x) - from.x, vy = (c.y - a.y) - from.y;
  const double left = ux * vy, right = uy * vx;
  const double size = std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy) + 1;
  // Each of the four numbers is off by at most 2 error_, two roundings of itself and what its
  // offsets (at most 1, together) lost: below d. So each product is off by d (|u| + |v|) + d^2, and
  // its own rounding.
  const double d = 2 * error_ + 0x1p-51 * size;
  const double bound = 4 * d * (size + d) + 0x1p-50 * (std::abs(left) + std::abs(right));
  // The corners are off the line by |cross| / |u|, less (|ux| + |uy|) / 2 |u|.
  return std::abs(left - right) > (std::abs(ux) + std::abs(uy)) / 2 + bound;
}

std::vector<VertexId> HotPixels::met_by(const Edge& edge) const {
  const VertexId first = places_.of_vertex[edge.tail], last = places_.of_vertex[edge.head];
  if (first == last) return {first};
  std::vector<VertexId> met{first, last};
  const Point &a = points_[edge.tail], &b = points_[edge.head];
  const double reach = tree_.above(kReach);
  tree_.visit(first, last, reach, [&](VertexId pixel, double) {
    if (pixel == first || pixel == last || is_far(edge, pixel)) return;
    if (meets_pixel(a, b, places_.points[pixel])) met.push_back(pixel);
  });
  // Edges run rightwards, or straight up: in x, and then in y, they meet pixels in order.
  const bool downwards = b.y < a.y;
  std::sort(met.begin(), met.end(), [&](VertexId p, VertexId q) {
    const Point &c = places_.points[p], &d = places_.points[q];
    return downwards && c.x == d.x ? q < p : p < q;
  });
  ensure(met.front() == first && met.back() == last, "an edge starts and ends in hot pixels");
  return met;
}

}  // namespace plumbline::round_steps
