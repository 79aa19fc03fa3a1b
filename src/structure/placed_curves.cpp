#include "structure/placed_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "structure/unit_frame.hpp"

namespace plumbline {
namespace {

/// Of the largest coordinate.
constexpr double kSlack = 0x1p-48;

double length(const Point& u) { return std::hypot(nearest_double(u.x), nearest_double(u.y)); }

/// No point of the ellipse is further from its centre.
double reach_of(const Ellipse& e) { return std::hypot(length(e.u), length(e.v)); }

int turn(const Point& s, const Point& t) { return sgn(Rational(s.x * t.y - s.y * t.x)); }

}  // namespace

CurvesInPlace::CurvesInPlace(const PlacedCurves& placed)
    : segments(placed.set.segments), curves(placed.curves), rounding(placed.rounding) {
  is_chord.resize(segments.size());
  for (const Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.count; ++i) is_chord[curve.first + i] = true;
  }
  BoxD box{};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto [a, b] = rough(i);
    if (i == 0) box = {a, a};
    box.include(a);
    box.include(b);
  }
  extent = box.longer_side();
  slack = std::max(slack_at(box.low), slack_at(box.high));
}

PointD CurvesInPlace::rough(std::size_t segment, bool is_b) const {
  const auto n = segments.numbers(segment);
  return is_b ? PointD{nearest_double(n[2]), nearest_double(n[3])}
              : PointD{nearest_double(n[0]), nearest_double(n[1])};
}

Point CurvesInPlace::end_of(std::size_t segment, bool is_b) const {
  const auto n = segments.numbers(segment);
  return is_b ? Point{n[2].rational(), n[3].rational()} : Point{n[0].rational(), n[1].rational()};
}

std::optional<std::size_t> CurvesInPlace::chord_before(const Curve& curve,
                                                       std::size_t chord) const {
  if (chord != curve.first) return chord - 1;
  if (is_closed(curve)) return curve.first + curve.count - 1;
  return std::nullopt;
}

std::optional<std::size_t> CurvesInPlace::chord_after(const Curve& curve, std::size_t chord) const {
  if (chord + 1 != curve.first + curve.count) return chord + 1;
  if (is_closed(curve)) return curve.first;
  return std::nullopt;
}

double CurvesInPlace::slack_at(const PointD& p) {
  return kSlack * std::max(std::abs(p.x), std::abs(p.y));
}

BoxD CurvesInPlace::around(const Point& p, double bound) const {
  const PointD at = nearest(p);
  return grown({at, at}, within(bound) + slack_at(at));
}

double CurvesInPlace::within(double bound) const { return std::min(bound, kMostJoined * extent); }

std::vector<Authored> authored_points(const CurvesInPlace& in) {
  std::vector<Authored> points;
  for (std::size_t s = 0; s < in.segments.size(); ++s) {
    if (in.is_chord[s]) continue;
    for (const bool is_b : {false, true}) points.push_back({in.end_of(s, is_b), in.rounding[s]});
  }
  for (std::size_t c = 0; c < in.curves.size(); ++c) {
    const Curve& curve = in.curves[c];
    if (in.is_closed(curve)) continue;
    if (curve.end_bounds[0] == 0) points.push_back({in.first_point(curve), 0, c});
    if (curve.end_bounds[1] == 0) points.push_back({in.last_point(curve), 0, c});
  }
  return points;
}

ChordTree::ChordTree(const CurvesInPlace& in) {
  for (std::size_t c = 0; c < in.curves.size(); ++c) {
    const Curve& curve = in.curves[c];
    if (!curve.ellipse || !UnitFrame::is_proper(*curve.ellipse)) continue;
    for (std::size_t i = 0; i < curve.count; ++i) {
      const auto [a, b] = in.rough(curve.first + i);
      BoxD box{a, a};
      box.include(b);
      chords_.push_back({curve.first + i, c});
      const double slack = std::max(in.slack_at(a), in.slack_at(b));
      boxes_.push_back(grown(box, curve.chord_bound + in.within(curve.bound) + slack));
    }
  }
  tree_ = std::make_unique<BoxTree>(boxes_);
}

PointsOnCurves points_on_curves(const CurvesInPlace& in, const ChordTree& chords,
                                const std::vector<Authored>& points) {
  PointsOnCurves result;
  const auto add = [&](const Authored& p, const ChordTree::Chord& chord) {
    const Curve& curve = in.curves[chord.curve];
    const UnitFrame frame(*curve.ellipse);
    const Point q = frame.in(p.at);
    // |q|^2 - 1 is about twice what q is off by.
    const double excess = nearest_double(Rational(q.x * q.x + q.y * q.y - 1));
    const double off = std::abs(excess) / 2 * reach_of(*curve.ellipse);
    if (off > in.within(curve.bound + p.rounding)) return;
    const Point a = in.end_of(chord.segment, false), b = in.end_of(chord.segment, true);
    if (p.at == a || p.at == b) return;
    const double bound = in.within(curve.bound + p.rounding);
    const std::optional<std::size_t> before = in.chord_before(curve, chord.segment);
    if (before && nearest_sqrt(squared_distance(p.at, a)) <= bound) {
      result.joints.push_back({*before, Joint::At::End, p.at});
      result.joints.push_back({chord.segment, Joint::At::Start, p.at});
    }
    const Point from = frame.in(a), to = frame.in(b);
    const int way = turn(from, to), past_from = turn(from, q);
    const bool is_at_from = past_from == 0 && sgn(Rational(from.x * q.x + from.y * q.y)) > 0;
    if (way == 0 || !(past_from == way || is_at_from) || turn(q, to) != way) return;
    result.joints.push_back({chord.segment, Joint::At::Inside, p.at});
    ++result.count;
    result.farthest = std::max(result.farthest, off);
  };
  for (const Authored& p : points) {
    for (const std::size_t i : chords.tree().meeting(in.around(p.at, p.rounding))) {
      if (chords.chords()[i].curve != p.curve) add(p, chords.chords()[i]);
    }
  }
  return result;
}

}  // namespace plumbline
