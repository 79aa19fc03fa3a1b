// Brute force intersection within the buckets, section 2.2, with the original's arithmetic: a
// product with the reciprocal of the determinant, sums from left to right. In parallel, since what
// the original adds to lists is made unique and sorted in the end.

#include <algorithm>
#include <optional>
#include <string>

#include "engines/inters/stages/hash_order.hpp"
#include "engines/lar/stages/parallel.hpp"
#include "geometry/point_d.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

using lar::for_blocks;

constexpr std::size_t kLinesPerBlock = 64;

struct Parameters {
  double alpha;
  double beta;
};

bool is_apart(const Box& s, const Box& t) {
  return t[2] < s[0] || s[2] < t[0] || t[3] < s[1] || s[3] < t[1];
}

bool is_on_segment(double parameter) { return 0 <= parameter && parameter <= 1; }

/// Solves alpha (p2 - p1) + beta (p3 - p4) = p3 - p1 (segmentIntersect).
std::optional<Parameters> intersect(const SegmentD& s, const SegmentD& t) {
  const double a = s.b.x - s.a.x, b = s.b.y - s.a.y;
  const double c = t.a.x - t.b.x, d = t.a.y - t.b.y;
  const double determinant = a * d - b * c;
  if (determinant == 0) return std::nullopt;
  const double reciprocal = 1 / determinant;
  const double x = t.a.x - s.a.x, y = t.a.y - s.a.y;
  const double alpha = x * (d * reciprocal) + y * (-c * reciprocal);
  const double beta = x * (-b * reciprocal) + y * (a * reciprocal);
  if (!is_on_segment(alpha) || !is_on_segment(beta)) return std::nullopt;
  return Parameters{alpha, beta};
}

/// Distinct values; repeated ones take no room: in a pencil of n lines each is cut n times in one
/// point.
template <class T>
class Distinct {
 public:
  void insert(const T& value) {
    if (!values_.empty() && values_.back() == value) return;
    if (values_.size() >= limit_) {
      sort_unique();
      limit_ = kRoom + 2 * values_.size();
    }
    values_.push_back(value);
  }
  void insert(const Distinct& other) {
    values_.insert(values_.end(), other.values_.begin(), other.values_.end());
  }
  /// Ascending.
  std::vector<T> take() {
    sort_unique();
    return std::move(values_);
  }

 private:
  static constexpr std::size_t kRoom = 64;

  void sort_unique() {
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
  }

  std::vector<T> values_;
  std::size_t limit_ = kRoom;
};

/// Where its partners cut a segment.
struct Cuts {
  Distinct<double> parameters;  ///< quantised
  Distinct<PointD> points;      ///< quantised
};

/// The original meets a pair twice, first h with k and then k with h, and cuts both segments each
/// time; their parameters need not be the same.
Cuts cut(std::size_t h, std::span<const SegmentD> lines, std::span<const Box> boxes,
         std::span<const SegmentId> partners, const Vcode& vcode) {
  Cuts result;
  for (const SegmentId k : partners) {
    if (is_apart(boxes[h], boxes[k])) continue;
    if (const auto found = intersect(lines[h], lines[k])) {
      result.parameters.insert(vcode.quantised(found->alpha));
      result.points.insert(vcode.quantised(point_at(lines[h], found->alpha)));
    }
    if (const auto found = intersect(lines[k], lines[h])) {
      result.parameters.insert(vcode.quantised(found->beta));
    }
  }
  return result;
}

/// The distinct quantised segments, by their text, in the order of a dictionary.
std::vector<Fragment> fragments_of(std::span<const SegmentD> lines, std::vector<Cuts> cuts,
                                   const Vcode& vcode) {
  HashTable<std::string> keys;
  std::vector<SegmentD> segments;
  std::vector<Distinct<double>> parameters;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string key = '[' + vcode.text(lines[i].a) + ',' + vcode.text(lines[i].b) + ']';
    const auto [fragment, is_new] = keys.insert(key);
    if (is_new) {
      segments.push_back(vcode.quantised(lines[i]));
      parameters.push_back(std::move(cuts[i].parameters));
    } else {
      parameters[fragment].insert(cuts[i].parameters);
    }
  }
  std::vector<Fragment> result;
  for (const std::size_t i : keys.order()) result.push_back({segments[i], parameters[i].take()});
  return result;
}

}  // namespace

Intersections line_intersection(std::span<const SegmentD> lines, std::span<const Box> boxes,
                                const Lists<SegmentId>& buckets, const Vcode& vcode) {
  std::vector<Cuts> cuts(lines.size());
  for_blocks(lines.size(), kLinesPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      cuts[h] = cut(h, lines, boxes, buckets[h], vcode);
    }
  });
  Distinct<PointD> points;
  for (const Cuts& segment_cuts : cuts) points.insert(segment_cuts.points);
  return {points.take(), fragments_of(lines, std::move(cuts), vcode)};
}

}  // namespace plumbline::inters
