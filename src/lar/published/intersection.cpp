// Brute force intersection within the buckets, section 2.2, with the original's arithmetic: a
// product with the reciprocal of the determinant, sums from left to right.

#include <algorithm>
#include <optional>
#include <string>

#include "lar/published/hash_order.hpp"
#include "lar/published/stages.hpp"

namespace plumbline::lar::published {
namespace {

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

PointD point_at(const SegmentD& s, double parameter) {
  return {s.a.x + parameter * (s.b.x - s.a.x), s.a.y + parameter * (s.b.y - s.a.y)};
}

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The parameters of the segments, stored by their quantised text.
class PointStorage {
 public:
  PointStorage(std::span<const SegmentD> lines, const Vcode& vcode) : vcode_(vcode) {
    for (const SegmentD& line : lines) {
      const std::string key = '[' + vcode.text(line.a) + ',' + vcode.text(line.b) + ']';
      const auto [fragment, is_new] = keys_.insert(key);
      if (is_new) fragments_.push_back({vcode.quantised(line), {}});
      fragment_of_.push_back(fragment);
    }
  }

  void add(std::size_t line, double parameter) {
    fragments_[fragment_of_[line]].parameters.push_back(parameter);
  }

  std::vector<Fragment> fragments() const {
    std::vector<Fragment> result;
    for (const std::size_t i : keys_.order()) {
      Fragment fragment = fragments_[i];
      for (double& parameter : fragment.parameters) parameter = vcode_.quantised(parameter);
      sort_unique(fragment.parameters);
      result.push_back(std::move(fragment));
    }
    return result;
  }

 private:
  const Vcode& vcode_;
  HashTable<std::string> keys_;
  std::vector<Fragment> fragments_;
  std::vector<std::size_t> fragment_of_;  ///< per segment
};

}  // namespace

Intersections line_intersection(std::span<const SegmentD> lines, std::span<const Box> boxes,
                                const Lists<SegmentId>& buckets, const Vcode& vcode) {
  PointStorage storage(lines, vcode);
  Intersections result;
  for (std::size_t h = 0; h < lines.size(); ++h) {
    for (const SegmentId k : buckets[h]) {
      if (is_apart(boxes[h], boxes[k])) continue;
      const std::optional<Parameters> found = intersect(lines[h], lines[k]);
      if (!found) continue;
      storage.add(h, found->alpha);
      storage.add(k, found->beta);
      result.points.push_back(vcode.quantised(point_at(lines[h], found->alpha)));
    }
  }
  sort_unique(result.points);
  result.fragments = storage.fragments();
  return result;
}

}  // namespace plumbline::lar::published
