// Divides the box of a polygon into squares, the one with the best prospects first: no circle with
// its centre in a square is larger than the distance of the square's middle from the sides and half
// its diagonal. Source: V. Agafonkin, "A new algorithm for finding a visual center of a polygon",
// 2016.

#include "rooms/inscribed_circle.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <queue>

namespace plumbline::rooms_steps {
namespace {

constexpr double kPrecision = 0.02;
constexpr double kMostSquares = 256;        // of a very long box, in a row
constexpr std::size_t kMostLooks = 20'000;  // then the best one so far will do

double squared_distance(const PointD& p, const SegmentD& s) {
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  const double along = ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  const double x = s.a.x + t * dx - p.x, y = s.a.y + t * dy - p.y;
  return x * x + y * y;
}

/// Which points are inside: sides by the heights that they reach across.
class Inside {
 public:
  explicit Inside(const std::vector<SegmentD>& sides) : sides_(sides) {
    low_ = high_ = sides.front().a.y;
    for (const SegmentD& s : sides) {
      low_ = std::min({low_, s.a.y, s.b.y});
      high_ = std::max({high_, s.a.y, s.b.y});
    }
    bands_.resize(static_cast<std::size_t>(std::sqrt(static_cast<double>(sides.size()))) + 1);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto [low, high] = std::minmax({sides[i].a.y, sides[i].b.y});
      for (std::size_t band = band_of(low); band <= band_of(high); ++band) {
        bands_[band].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }

  bool operator()(const PointD& p) const {
    if (p.y < low_ || p.y > high_) return false;
    bool inside = false;
    for (const std::uint32_t i : bands_[band_of(p.y)]) {
      const auto& [a, b] = sides_[i];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }

 private:
  std::size_t band_of(double y) const {
    const double part = high_ > low_ ? (y - low_) / (high_ - low_) : 0;
    return std::min(static_cast<std::size_t>(part * static_cast<double>(bands_.size())),
                    bands_.size() - 1);
  }

  const std::vector<SegmentD>& sides_;
  double low_, high_;
  std::vector<std::vector<std::uint32_t>> bands_;
};

using Candidates = std::vector<std::uint32_t>;

struct Square {
  PointD middle;
  double half = 0;  ///< of a side
  double most = 0;  ///< no circle with its centre in here has a larger radius
  std::shared_ptr<const Candidates> candidates;  ///< sides that are nearest to some point in here

  bool operator<(const Square& other) const {
    if (most != other.most) return most < other.most;
    return other.middle < middle;
  }
};

class Search {
 public:
  Search(const std::vector<SegmentD>& sides, double least)
      : sides_(sides), inside_(sides), least_(least) {}

  Circle run() {
    cover_box();
    for (std::size_t looked = 0; looked < kMostLooks && !squares_.empty(); ++looked) {
      const Square square = squares_.top();
      squares_.pop();
      if (!is_promising(square.most)) break;
      const double half = square.half / 2;
      for (const double x : {-half, half}) {
        for (const double y : {-half, half}) {
          look_at({square.middle.x + x, square.middle.y + y}, half, *square.candidates);
        }
      }
    }
    return best_;
  }

 private:
  void cover_box() {
    PointD low = sides_.front().a, high = low;
    for (const SegmentD& s : sides_) {
      low = {std::min({low.x, s.a.x, s.b.x}), std::min({low.y, s.a.y, s.b.y})};
      high = {std::max({high.x, s.a.x, s.b.x}), std::max({high.y, s.a.y, s.b.y})};
    }
    const double width = high.x - low.x, height = high.y - low.y;
    slack_ = kPrecision * least_;
    if (least_ == 0) slack_ = kPrecision * std::max(width, height) / 20;
    const double step = std::max(std::min(width, height), std::max(width, height) / kMostSquares);
    if (std::min(width, height) < 2 * least_ || !(step > 0) || !std::isfinite(step)) return;
    Candidates all(sides_.size());
    std::iota(all.begin(), all.end(), std::uint32_t{0});
    // Of circles that are as large, as in an oblong room, the one in the middle.
    look_at({low.x + width / 2, low.y + height / 2}, 0, all);
    for (int i = 0; i < std::ceil(width / step); ++i) {
      for (int j = 0; j < std::ceil(height / step); ++j) {
        look_at({low.x + (i + 0.5) * step, low.y + (j + 0.5) * step}, step / 2, all);
      }
    }
  }

  bool is_promising(double most) const {
    return most > best_.radius * (1 + kPrecision) + slack_ && most >= least_;
  }

  void look_at(const PointD& middle, double half, const Candidates& candidates) {
    distances_.clear();
    for (const std::uint32_t i : candidates) {
      distances_.push_back(squared_distance(middle, sides_[i]));
    }
    const double distance = std::sqrt(*std::min_element(distances_.begin(), distances_.end()));
    const bool inside = inside_(middle);
    if (inside && distance > best_.radius) best_ = {middle, distance};
    const double reach = half * std::numbers::sqrt2;
    const double most = (inside ? distance : -distance) + reach;
    // Squares as small as rounding have no prospects.
    const bool is_tiny = middle.x + half == middle.x || middle.y + half == middle.y;
    if (!is_promising(most) || is_tiny) return;
    constexpr double kRounding = 1 + 1e-9;
    const double furthest = (distance + 2 * reach) * (distance + 2 * reach) * kRounding;
    auto nearest = std::make_shared<Candidates>();
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (distances_[k] <= furthest) nearest->push_back(candidates[k]);
    }
    squares_.push({middle, half, most, std::move(nearest)});
  }

  const std::vector<SegmentD>& sides_;
  const Inside inside_;
  const double least_;
  double slack_ = 0;  ///< what is larger by less than this is no better
  Circle best_;
  std::priority_queue<Square> squares_;
  std::vector<double> distances_;  ///< of the candidates that are looked at
};

}  // namespace

Circle inscribed_circle(const std::vector<SegmentD>& sides, double least) {
  return sides.empty() ? Circle{} : Search(sides, least).run();
}

}  // namespace plumbline::rooms_steps
