// Looks for a chain of edges along a segment: depth first, always forward.

#include "compare/chain.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace plumbline::compare_steps {
namespace {

/// Some hundred roundings of the numbers in `is_surely_far` and `is_further`, whose products have
/// few.
constexpr double kSlack = 0x1p-45;
/// Far more than what products lose below 2^-1022.
constexpr double kUnderflow = 0x1p-1000;

class ChainSearch {
 public:
  ChainSearch(const Sides& sides, Side side, VertexId goal, const Segment& ab,
              const std::vector<bool>& is_usable, std::size_t& steps)
      : sides_(sides), side_(side), goal_(goal), ab_(ab), is_usable_(is_usable), steps_(steps) {}

  std::vector<HalfedgeId> from(VertexId start) {
    visited_.insert(start);
    open(start);
    std::vector<HalfedgeId> walk;
    for (std::size_t dead_ends = 0; !stack_.empty() && dead_ends <= kMaxDeadEnds;) {
      const Step step = stack_.back();
      stack_.pop_back();
      walk.resize(step.depth);
      walk.push_back(step.halfedge);
      const VertexId v = sides_[side_].target(step.halfedge);
      if (v == goal_) return walk;
      depth_ = walk.size();
      const std::size_t open_before = stack_.size();
      if (visited_.insert(v).second) open(v);
      if (stack_.size() == open_before) ++dead_ends;
    }
    return {};
  }

 private:
  struct Step {
    HalfedgeId halfedge;
    std::size_t depth;
  };

  void open(VertexId v) {
    for (const HalfedgeId h : sides_.outgoing[side_][v]) {
      if (steps_ == 0) return;
      --steps_;
      if (!is_usable_[edge_of(h)]) continue;
      const VertexId w = sides_[side_].target(h);
      if (w == goal_ ||
          (!visited_.contains(w) && !is_surely_far(w) && is_further(w, v) && is_near(w))) {
        stack_.push_back({h, depth_});
      }
    }
  }

  /// Doubles tell of most vertices that they lie further from the line than the tolerance.
  bool is_surely_far(VertexId v) const {
    const PointD& p = sides_.points[side_].rough(v);
    const double dx = b_.x - a_.x, dy = b_.y - a_.y, length = std::hypot(dx, dy);
    const double away = std::abs(dx * (p.y - a_.y) - dy * (p.x - a_.x));
    const double size = std::max({size_, std::abs(p.x), std::abs(p.y)});
    return away > length * (sides_.tolerance * (1 + kSlack) + size * kSlack);
  }

  /// Doubles tell of most of the others that they lie nearer to it.
  bool is_surely_near(VertexId v) const {
    const PointD& p = sides_.points[side_].rough(v);
    const double dx = b_.x - a_.x, dy = b_.y - a_.y, squared_length = dx * dx + dy * dy;
    if (!(squared_length > kUnderflow)) return false;
    const double part =
        std::clamp(((p.x - a_.x) * dx + (p.y - a_.y) * dy) / squared_length, 0.0, 1.0);
    const double away = std::hypot(p.x - (a_.x + part * dx), p.y - (a_.y + part * dy));
    const double size = std::max({size_, std::abs(p.x), std::abs(p.y)});
    return away + size * kSlack < sides_.tolerance;
  }

  /// Whether v is further along ab than w is. Doubles tell where it is so by more than rounding.
  bool is_further(VertexId v, VertexId w) const {
    const PointD &p = sides_.points[side_].rough(v), &q = sides_.points[side_].rough(w);
    const double dx = b_.x - a_.x, dy = b_.y - a_.y;
    const double by = (p.x - q.x) * dx + (p.y - q.y) * dy;
    const double size =
        std::max({size_, std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)});
    const double lengths =
        std::abs(dx) + std::abs(dy) + std::abs(p.x - q.x) + std::abs(p.y - q.y) + size * kSlack;
    if (std::abs(by) > lengths * size * kSlack + kUnderflow) return by > 0;
    return advance(v) > advance(w);
  }
  /// How far along ab, times the squared length of ab.
  Rational advance(VertexId v) const {
    const Point& p = sides_.point(side_, v);
    return (p.x - ab_.a.x) * (ab_.b.x - ab_.a.x) + (p.y - ab_.a.y) * (ab_.b.y - ab_.a.y);
  }
  bool is_near(VertexId v) const {
    return is_surely_near(v) ||
           squared_distance(sides_.point(side_, v), ab_.a, ab_.b) <= sides_.squared_tolerance;
  }

  const Sides& sides_;
  const Side side_;
  const VertexId goal_;
  const Segment& ab_;
  const PointD a_ = nearest(ab_.a), b_ = nearest(ab_.b);
  const double size_ = std::max({std::abs(a_.x), std::abs(a_.y), std::abs(b_.x), std::abs(b_.y)});
  const std::vector<bool>& is_usable_;
  std::size_t& steps_;
  std::unordered_set<std::size_t> visited_;
  std::vector<Step> stack_;
  std::size_t depth_ = 0;
};

}  // namespace

std::vector<HalfedgeId> chain_along(const Sides& sides, Side side, VertexId p, VertexId q,
                                    const Segment& ab, const std::vector<bool>& is_usable,
                                    std::size_t& steps) {
  return ChainSearch(sides, side, q, ab, is_usable, steps).from(p);
}

}  // namespace plumbline::compare_steps
