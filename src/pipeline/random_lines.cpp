// Random segments, appendix (randomLines, redge, rpoint2d).

#include <algorithm>
#include <cmath>
#include <random>

#include "plumbline/engines/inters_vcode.hpp"
#include "plumbline/error.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline {
namespace {

/// Random points of the unit square with the default number of decimals; the same on every machine,
/// unlike the standard library's distributions.
class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : random_(seed), vcode_(inters::kDecimals) {}
  PointD operator()() {
    const double x = uniform();
    return vcode_.quantised(PointD{x, uniform()});
  }
  const inters::Vcode& vcode() const { return vcode_; }

 private:
  double uniform() { return std::ldexp(static_cast<double>(random_() >> 11U), -53); }
  std::mt19937_64 random_;
  inters::Vcode vcode_;
};

SegmentD random_line(RandomPoints& points, double scaling) {
  const PointD v1 = points(), v2 = points();
  const PointD center{(v1.x + v2.x) / 2, (v1.y + v2.y) / 2};
  const PointD position = points();
  const auto placed = [&](const PointD& v) {
    return PointD{(v.x - center.x) * scaling + position.x, (v.y - center.y) * scaling + position.y};
  };
  return points.vcode().quantised(SegmentD{placed(v1), placed(v2)});
}

}  // namespace

std::vector<SegmentD> random_lines(std::size_t n, double scaling, std::uint64_t seed) {
  if (!std::isfinite(scaling)) {
    throw Error(ErrorCode::BadInput, "the scaling of random segments must be finite", {},
                shortest_text(scaling));
  }
  RandomPoints points(seed);
  std::vector<SegmentD> lines;
  for (std::size_t i = 0; i < n; ++i) lines.push_back(random_line(points, scaling));
  double x = 0, y = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& [a, b] = lines[i];
    x = i == 0 ? std::min(a.x, b.x) : std::min({x, a.x, b.x});
    y = i == 0 ? std::min(a.y, b.y) : std::min({y, a.y, b.y});
  }
  for (SegmentD& line : lines) {
    line = {{line.a.x - x, line.a.y - y}, {line.b.x - x, line.b.y - y}};
  }
  const auto is_finite = [](const PointD& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (!std::ranges::all_of(
          lines, [&](const SegmentD& line) { return is_finite(line.a) && is_finite(line.b); })) {
    throw Error(ErrorCode::BadInput,
                "the scaling of random segments makes coordinates beyond the largest double", {},
                shortest_text(scaling));
  }
  return lines;
}

}  // namespace plumbline
