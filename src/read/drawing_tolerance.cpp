#include "read/drawing_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plumbline/geometry/extent.hpp"

namespace plumbline {
namespace {

constexpr double kDrawingPart = 5000;
constexpr std::size_t kMostLookedAt = std::size_t{1} << 22U;

/// A map of the plane in doubles.
struct MapD {
  double a, c, e, b, d, f;

  PointD operator()(const Number& x, const Number& y) const {
    const double u = nearest_double(x), v = nearest_double(y);
    return {a * u + c * v + e, b * u + d * v + f};
  }
  /// By how much it enlarges a length at most.
  double factor() const {
    const double sum = std::hypot(a + d, b - c), difference = std::hypot(a - d, b + c);
    return (sum + difference) / 2;
  }
};

MapD rounded(const Affine& map) {
  const auto at = [&](std::size_t i) { return nearest_double(map.entries()[i]); };
  return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

/// Of Bezier curves in SVG nothing but the element is known.
bool may_have_curves(const Model& model) {
  return !model.curves.empty() || model.source.element == "path";
}

}  // namespace

Rational drawing_tolerance(const Structure& structure) {
  std::vector<SegmentD> segments;
  double largest_factor = 0;
  for (Traversal at(structure); segments.size() < kMostLookedAt && at.next();) {
    const Model* model = std::get_if<Model>(&at.model());
    if (model == nullptr || model->segments.empty()) continue;
    const MapD map = rounded(at.map());
    if (may_have_curves(*model)) largest_factor = std::max(largest_factor, map.factor());
    for (std::size_t i = 0; i < model->segments.size(); ++i) {
      const auto n = model->segments.numbers(i);
      segments.push_back({map(n[0], n[1]), map(n[2], n[3])});
    }
  }
  const double tolerance = extent(segments).longer_side() / kDrawingPart / largest_factor;
  return std::isfinite(tolerance) ? rational_from(tolerance) : Rational(0);
}

Structure read_within_tolerance(const ReadOptions& options, const ReadFunction& read) {
  if (sgn(options.chord_tolerance) > 0) return read(options, 0).structure;
  const Rational coarsest = rational_from(0x1p+1000);
  Rational tolerance;
  {
    ReadOptions with_curves = options;
    with_curves.join_curves = true;  // else models do not say which of their segments are chords
    Reading coarse = read(with_curves, coarsest);
    if (!coarse.has_curves) return std::move(coarse.structure);
    tolerance = drawing_tolerance(coarse.structure);
  }
  return read(options, tolerance).structure;
}

}  // namespace plumbline
