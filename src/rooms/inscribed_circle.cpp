// Divides the box of a polygon into squares, the one with the best prospects first: no circle with
// its centre in a square is larger than the distance of the square's middle from the sides and half
// its diagonal. Source: V. Agafonkin, "A new algorithm for finding a visual center of a polygon",
// 2016.

#include "rooms/inscribed_circle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace plumbline::rooms_steps {
namespace {

constexpr double kPrecision = 0.02;

double squared_distance(const PointD& p, const SegmentD& s) {
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  const double along = ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  const double x = s.a.x + t * dx - p.x, y = s.a.y + t * dy - p.y;
  return x * x + y * y;
}

struct Square {
  PointD middle;
  double half = 0;      ///< of a side
  double distance = 0;  ///< of the middle from the sides; negative outside
  double most = 0;      ///< no circle with its centre in here has a larger radius

  bool operator<(const Square& other) const {
    if (most != other.most) return most < other.most;
    return other.middle < middle;
  }
};

/// The distance of p from the sides, negative outside.
double signed_distance(const std::vector<SegmentD>& sides, const PointD& p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const SegmentD& s : sides) {
    least = std::min(least, squared_distance(p, s));
    if ((s.a.y > p.y) == (s.b.y > p.y)) continue;
    if (p.x < s.a.x + (p.y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x)) inside = !inside;
  }
  return inside ? std::sqrt(least) : -std::sqrt(least);
}

class Search {
 public:
  Search(const std::vector<SegmentD>& sides, double least) : sides_(sides), least_(least) {}

  Circle run() {
    cover_box();
    while (!squares_.empty()) {
      const Square square = squares_.top();
      squares_.pop();
      if (!is_promising(square)) break;
      const double half = square.half / 2;
      for (const double x : {-half, half}) {
        for (const double y : {-half, half}) {
          look_at({square.middle.x + x, square.middle.y + y}, half);
        }
      }
    }
    return best_;
  }

 private:
  void cover_box() {
    PointD low = sides_.front().a, high = low;
    for (const SegmentD& s : sides_) {
      low = {std::min(low.x, s.a.x), std::min(low.y, s.a.y)};
      high = {std::max(high.x, s.a.x), std::max(high.y, s.a.y)};
    }
    const double side = std::min(high.x - low.x, high.y - low.y);
    constexpr double kMostSquares = 256;  // of a very long box, in a row
    const double step =
        std::max({side, (high.x - low.x) / kMostSquares, (high.y - low.y) / kMostSquares});
    if (!(step > 0) || !std::isfinite(step)) return;
    for (double x = low.x; x < high.x; x += step) {
      for (double y = low.y; y < high.y; y += step) {
        look_at({x + step / 2, y + step / 2}, step / 2);
      }
    }
  }

  bool is_promising(const Square& square) const {
    return square.most > best_.radius * (1 + kPrecision) && square.most >= least_;
  }

  void look_at(const PointD& middle, double half) {
    Square square{middle, half, signed_distance(sides_, middle), 0};
    square.most = square.distance + half * std::numbers::sqrt2;
    if (square.distance > best_.radius) best_ = {middle, square.distance};
    // Squares as small as rounding have no prospects.
    const bool is_tiny = middle.x + half == middle.x || middle.y + half == middle.y;
    if (is_promising(square) && !is_tiny) squares_.push(square);
  }

  const std::vector<SegmentD>& sides_;
  double least_;
  Circle best_;
  std::priority_queue<Square> squares_;
};

}  // namespace

Circle inscribed_circle(const std::vector<SegmentD>& sides, double least) {
  return sides.empty() ? Circle{} : Search(sides, least).run();
}

}  // namespace plumbline::rooms_steps
