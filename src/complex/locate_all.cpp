// Locates many points at once: a line sweeps upwards over edges and points, and each point looks
// at the edges that the line meets. A point stands for one infinitesimally above it, so that no ray
// runs through a vertex.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plumbline/complex.hpp"

namespace plumbline {
namespace {

/// Two signed units in the last place of the largest coordinate, times a dozen operations: bounds
/// the rounding of a crossing computed in doubles.
constexpr double kCrossingSlack = 0x1p-48;

/// A non-horizontal edge, from its lower to its upper end.
struct Rising {
  HalfedgeId up;
  VertexId low, high;
  PointD low_d, high_d;
};

/// The points that are looked for, by ascending heights.
struct Heights {
  std::vector<double> rounded;

  /// Whether one may be within these heights; rounding is monotone.
  bool meet(double low, double high) const {
    const auto first = std::lower_bound(rounded.begin(), rounded.end(), low);
    return first != rounded.end() && *first <= high;
  }
};

/// The edges at these heights, by their lower ends. Rounding is monotone, so unequal doubles
/// decide.
std::vector<Rising> rising_edges(const ExactComplex& complex, const Heights& heights) {
  const PointList& points = complex.vertices;
  std::vector<PointD> rounded;
  rounded.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) rounded.push_back(points.nearest(v));
  const auto height_order = [&](VertexId v, VertexId w) {
    if (rounded[v].y != rounded[w].y) return rounded[v].y < rounded[w].y ? -1 : 1;
    return v == w ? 0 : points.compare_y(v, w);
  };
  std::vector<Rising> result;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const auto [tail, head] = complex.edges[e];
    const auto [low, high] = std::minmax(rounded[tail].y, rounded[head].y);
    if (!heights.meet(low, high)) continue;
    const int order = height_order(tail, head);
    if (order < 0) {
      result.push_back({halfedge(EdgeId(e), false), tail, head, rounded[tail], rounded[head]});
    } else if (order > 0) {
      result.push_back({halfedge(EdgeId(e), true), head, tail, rounded[head], rounded[tail]});
    }
  }
  std::stable_sort(result.begin(), result.end(), [&](const Rising& a, const Rising& b) {
    return height_order(a.low, b.low) < 0;
  });
  return result;
}

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
  Sweep(const ExactComplex& complex, double magnitude, const Heights& heights)
      : complex_(complex), magnitude_(magnitude), edges_(rising_edges(complex, heights)) {}

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
  /// Whether the vertex, at height y in doubles, is above p.
  bool is_above(VertexId v, double y, const Point& p, double p_y) const {
    return y != p_y ? y > p_y : complex_.vertices[v].y > p.y;
  }
  /// Keeps the edges that reach above the height of p but do not begin above it.
  void advance(const Point& p, double p_y) {
    while (next_ < edges_.size() && !is_above(edges_[next_].low, edges_[next_].low_d.y, p, p_y)) {
      active_.push_back(next_++);
    }
    std::erase_if(active_, [&](std::size_t i) {
      return !is_above(edges_[i].high, edges_[i].high_d.y, p, p_y);
    });
  }

  /// x = at + slope y on the edge.
  struct Line {
    Rational slope, at;
  };
  Line line(const Rising& e) const {
    const Point low = complex_.vertices[e.low], high = complex_.vertices[e.high];
    const Rational slope = (high.x - low.x) / (high.y - low.y);
    return {slope, low.x - slope * low.y};
  }
  bool is_right_of(const Rising& e, const Point& p) const {
    const Line l = line(e);
    const int side = cmp(Rational(l.at + l.slope * p.y), p.x);
    return side != 0 ? side > 0 : sgn(l.slope) >= 0;
  }
  bool is_before(const Rising& a, const Rising& b, const Rational& y) const {
    const Line of_a = line(a), of_b = line(b);
    const int by_x = cmp(Rational(of_a.at + of_a.slope * y), Rational(of_b.at + of_b.slope * y));
    return by_x != 0 ? by_x < 0 : of_a.slope < of_b.slope;
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
  std::vector<double> rounded;
  for (const Point& p : points) rounded.push_back(nearest(p).y);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rounded[a] != rounded[b] ? rounded[a] < rounded[b] : points[a].y < points[b].y;
  });
  Heights heights;
  for (const std::size_t i : order) heights.rounded.push_back(rounded[i]);
  Sweep sweep(complex, magnitude_of(complex, points), heights);
  std::vector<FaceId> result(points.size());
  for (const std::size_t i : order) result[i] = sweep.locate(points[i]);
  return result;
}

}  // namespace plumbline
