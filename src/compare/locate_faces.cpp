// Locates many points at once: a line sweeps upwards over edges and points, and each point looks
// at the edges that the line meets. A point stands for one infinitesimally above it, so that no ray
// runs through a vertex.

#include "compare/locate_faces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::compare_steps {
namespace {

/// Two signed units in the last place of the largest coordinate, times a dozen operations: bounds
/// the rounding of a crossing computed in doubles.
constexpr double kCrossingSlack = 0x1p-48;

/// A non-horizontal edge, from its lower to its upper end.
struct Rising {
  HalfedgeId up;
  Point low;
  Point high;
  PointD low_d, high_d;
};

/// Exact order by height; rounding is monotone, so unequal doubles decide.
bool is_lower(const Point& p, double p_y, const Point& q, double q_y) {
  return p_y != q_y ? p_y < q_y : p.y < q.y;
}

std::vector<Rising> rising_edges(const ExactComplex& complex) {
  std::vector<PointD> rounded;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    rounded.push_back(complex.vertices.nearest(v));
  }
  std::vector<Rising> result;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    auto [low, high] = complex.edges[e];
    Point p = complex.vertices[low], q = complex.vertices[high];
    if (p.y == q.y) continue;
    if (is_lower(q, rounded[high].y, p, rounded[low].y)) {
      std::swap(low, high);
      std::swap(p, q);
    }
    result.push_back({halfedge(EdgeId(e), low != complex.edges[e].tail), std::move(p), std::move(q),
                      rounded[low], rounded[high]});
  }
  std::stable_sort(result.begin(), result.end(), [](const Rising& a, const Rising& b) {
    return is_lower(a.low, a.low_d.y, b.low, b.low_d.y);
  });
  return result;
}

Rational slope(const Rising& e) { return (e.high.x - e.low.x) / (e.high.y - e.low.y); }
Rational crossing(const Rising& e, const Rational& y) { return e.low.x + (y - e.low.y) * slope(e); }

/// Where the line at height y meets the edge, certainly between `low` and `high`.
struct Interval {
  double low, high;
};
Interval approximate_crossing(const Rising& e, double y, double magnitude) {
  const double slack = kCrossingSlack * magnitude;
  const double dx = e.high_d.x - e.low_d.x, dy = e.high_d.y - e.low_d.y;
  if (dy <= slack) {
    return {std::min(e.low_d.x, e.high_d.x) - slack, std::max(e.low_d.x, e.high_d.x) + slack};
  }
  const double x = e.low_d.x + (y - e.low_d.y) / dy * dx;
  const double error = std::abs(dx) * slack / dy + slack;
  return {x - error, x + error};
}

class Sweep {
 public:
  Sweep(const ExactComplex& complex, double magnitude)
      : complex_(complex), magnitude_(magnitude), edges_(rising_edges(complex)) {}

  /// Requires: called with points of ascending y.
  FaceId locate(const Point& p) {
    const PointD rounded = nearest(p);
    advance(p, rounded.y);
    const double slack = kCrossingSlack * magnitude_;
    const Rising* first = nullptr;
    Interval first_at{};
    for (const std::size_t i : active_) {
      const Rising& e = edges_[i];
      const Interval at = approximate_crossing(e, rounded.y, magnitude_);
      if (at.high < rounded.x - slack || (first && at.low > first_at.high)) continue;
      if (!(at.low > rounded.x + slack) && !is_right_of(e, p)) continue;
      if (first && !(at.high < first_at.low) && !is_before(e, *first, p.y)) continue;
      first = &e;
      first_at = at;
    }
    return first ? complex_.halfedge_face[first->up] : kUnbounded;
  }

 private:
  /// Keeps the edges that reach above the height of p but do not begin above it.
  void advance(const Point& p, double p_y) {
    while (next_ < edges_.size() && !is_lower(p, p_y, edges_[next_].low, edges_[next_].low_d.y)) {
      active_.push_back(next_++);
    }
    std::erase_if(active_, [&](std::size_t i) {
      return !is_lower(p, p_y, edges_[i].high, edges_[i].high_d.y);
    });
  }
  static bool is_right_of(const Rising& e, const Point& p) {
    const int side = cmp(crossing(e, p.y), p.x);
    return side != 0 ? side > 0 : slope(e) >= 0;
  }
  static bool is_before(const Rising& a, const Rising& b, const Rational& y) {
    const int by_x = cmp(crossing(a, y), crossing(b, y));
    return by_x != 0 ? by_x < 0 : slope(a) < slope(b);
  }

  const ExactComplex& complex_;
  const double magnitude_;
  const std::vector<Rising> edges_;
  std::vector<std::size_t> active_;
  std::size_t next_ = 0;
};

double magnitude_of(const ExactComplex& complex, const std::vector<Point>& points) {
  double result = 0;
  const auto add = [&](const PointD& p) {
    result = std::max({result, std::abs(p.x), std::abs(p.y)});
  };
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) add(complex.vertices.nearest(v));
  for (const Point& p : points) add(nearest(p));
  return result;
}

}  // namespace

std::vector<FaceId> locate_all(const ExactComplex& complex, const std::vector<Point>& points) {
  if (points.empty()) return {};
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return points[a].y < points[b].y; });
  Sweep sweep(complex, magnitude_of(complex, points));
  std::vector<FaceId> result(points.size());
  for (const std::size_t i : order) result[i] = sweep.locate(points[i]);
  return result;
}

}  // namespace plumbline::compare_steps
