// Where curves meet what meets them: first their ends, then what lies on them or crosses them.

#include "structure/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/rejected.hpp"
#include "geometry/union_find.hpp"
#include "structure/placed_curves.hpp"

namespace plumbline {
namespace {

/// An end of a curve, known within a bound, and where it is to be.
struct End {
  std::size_t curve;
  bool is_last;
  Point at;
  double bound;
  std::optional<Point> place = {};

  const Point& settled() const { return place ? *place : at; }
};

double distance_of(const Point& p, const Point& q) { return nearest_sqrt(squared_distance(p, q)); }

/// Both ends of each open curve, one after the other. Those that are known exactly have their
/// place.
std::vector<End> ends_of_curves(const CurvesInPlace& in) {
  std::vector<End> ends;
  for (std::size_t c = 0; c < in.curves.size(); ++c) {
    const Curve& curve = in.curves[c];
    if (in.is_closed(curve)) continue;
    ends.push_back({c, false, in.first_point(curve), curve.end_bounds[0]});
    ends.push_back({c, true, in.last_point(curve), curve.end_bounds[1]});
  }
  // Ends in one place are known alike, so that what is one point stays one.
  std::map<Point, double> bound_at;
  for (const End& end : ends) {
    double& bound = bound_at[end.at];
    bound = std::max(bound, end.bound);
  }
  for (End& end : ends) {
    end.bound = bound_at[end.at];
    if (end.bound == 0) end.place = end.at;
  }
  return ends;
}

/// The ends that have no place yet, each with what lies within its bound and `more`.
class OpenEnds {
 public:
  OpenEnds(const CurvesInPlace& in, const std::vector<End>& ends, double more = 0) {
    std::vector<BoxD> boxes;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].place) continue;
      boxes.push_back(in.around(ends[i].at, ends[i].bound + more));
      numbers_.push_back(i);
    }
    tree_.emplace(boxes);
  }

  const std::vector<std::size_t>& numbers() const { return numbers_; }
  template <class Shape>
  std::vector<std::size_t> near(const Shape& shape) const {
    std::vector<std::size_t> found = tree_->meeting(shape);
    for (std::size_t& i : found) i = numbers_[i];
    return found;
  }

 private:
  std::vector<std::size_t> numbers_;
  std::optional<BoxTree> tree_;
};

/// The nearest of the places found for each end, and whether another one is as near.
class Nearest {
 public:
  explicit Nearest(std::size_t count) : choices_(count) {}

  void offer(std::size_t end, Rational squared, const Point& place) {
    std::optional<Choice>& choice = choices_[end];
    if (!choice || squared < choice->squared) {
      choice = {std::move(squared), place, false};
    } else if (squared == choice->squared && place != choice->place) {
      choice->is_tied = true;
    }
  }

  /// Gives the ends their places; returns those that have a choice of two.
  std::vector<std::size_t> settle(std::vector<End>& ends) const {
    std::vector<std::size_t> tied;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!choices_[i]) continue;
      if (choices_[i]->is_tied) {
        tied.push_back(i);
      } else {
        ends[i].place = choices_[i]->place;
      }
    }
    return tied;
  }

 private:
  struct Choice {
    Rational squared;
    Point place;
    bool is_tied;
  };
  std::vector<std::optional<Choice>> choices_;
};

std::vector<std::size_t> take_authored_ends(std::vector<End>& ends, const CurvesInPlace& in,
                                            const std::vector<Authored>& points) {
  const OpenEnds open(in, ends);
  Nearest nearest_place(ends.size());
  for (const Authored& p : points) {
    for (const std::size_t i : open.near(in.around(p.at, p.rounding))) {
      Rational squared = squared_distance(ends[i].at, p.at);
      if (nearest_sqrt(squared) > in.within(ends[i].bound + p.rounding)) continue;
      nearest_place.offer(i, std::move(squared), p.at);
    }
  }
  return nearest_place.settle(ends);
}

/// Ends of curves that nothing authored is near to, but each other: the place of the sharpest one.
void take_ends_of_curves(std::vector<End>& ends, const CurvesInPlace& in) {
  const OpenEnds open(in, ends);
  const auto are_near = [&](const End& a, const End& b) {
    return a.curve != b.curve && distance_of(a.at, b.at) <= in.within(a.bound + b.bound);
  };
  UnionFind sets(ends.size());
  for (const std::size_t i : open.numbers()) {
    for (const std::size_t j : open.near(in.around(ends[i].at, ends[i].bound))) {
      if (j != i && are_near(ends[i], ends[j])) sets.unite(i, j);
    }
  }
  std::map<std::size_t, std::size_t> sharpest;  // by set
  const auto is_sharper = [&](const End& a, const End& b) {
    return std::tie(a.bound, a.at) < std::tie(b.bound, b.at);
  };
  for (const std::size_t i : open.numbers()) {
    const auto [found, is_new] = sharpest.try_emplace(sets.find(i), i);
    if (!is_new && is_sharper(ends[i], ends[found->second])) found->second = i;
  }
  for (const std::size_t i : open.numbers()) {
    const End& best = ends[sharpest[sets.find(i)]];
    if (ends[i].at != best.at && are_near(ends[i], best)) ends[i].place = best.at;
  }
}

/// The rounding that nine of ten lines do not exceed: others may be strays far away.
double usual_rounding(const CurvesInPlace& in) {
  std::vector<double> sorted = in.rounding;
  if (sorted.empty()) return 0;
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), most, sorted.end());
  return *most;
}

/// Ends that are near no other one, but lie on a line.
std::vector<std::size_t> take_lines(std::vector<End>& ends, const CurvesInPlace& in) {
  const double usual = usual_rounding(in);
  const OpenEnds open(in, ends, usual);
  const auto near_line = [&](std::size_t s) {
    const SegmentD line = in.rough(s);
    if (in.rounding[s] <= usual) return open.near(line);
    BoxD box{line.a, line.a};
    box.include(line.b);
    return open.near(grown(box, in.within(in.rounding[s])));
  };
  Nearest nearest_foot(ends.size());
  for (std::size_t s = 0; s < in.segments.size(); ++s) {
    if (in.is_chord[s] || open.numbers().empty()) continue;
    for (const std::size_t i : near_line(s)) {
      const Point a = in.end_of(s, false), b = in.end_of(s, true);
      const Rational ux = b.x - a.x, uy = b.y - a.y;
      const Rational along =
          (ux * (ends[i].at.x - a.x) + uy * (ends[i].at.y - a.y)) / (ux * ux + uy * uy);
      if (sgn(along) <= 0 || cmp(along, 1) >= 0) continue;
      const Point foot{a.x + along * ux, a.y + along * uy};
      Rational squared = squared_distance(foot, ends[i].at);
      if (nearest_sqrt(squared) > in.within(ends[i].bound + in.rounding[s])) continue;
      nearest_foot.offer(i, std::move(squared), foot);
    }
  }
  return nearest_foot.settle(ends);
}

/// The ends that move. An arc stays one: its two ends do not become one point.
PointsOnCurves moved_ends(std::vector<End>& ends, const CurvesInPlace& in) {
  PointsOnCurves moved;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    End &first = ends[i], &last = ends[i + 1];
    if (first.settled() == last.settled()) {
      first.place = first.at;
      last.place = last.at;
    }
    for (const End* end : {&first, &last}) {
      if (end->settled() == end->at) continue;
      const Curve& curve = in.curves[end->curve];
      const std::size_t chord = end->is_last ? curve.first + curve.count - 1 : curve.first;
      const Joint::At at = end->is_last ? Joint::At::End : Joint::At::Start;
      moved.joints.push_back({chord, at, end->settled()});
      ++moved.count;
      moved.farthest = std::max(moved.farthest, distance_of(end->at, end->settled()));
    }
  }
  return moved;
}

/// By chord, along it, each place once.
void sort(std::vector<Joint>& joints, const CurvesInPlace& in) {
  std::vector<std::pair<Rational, Joint>> keyed;  // with the way along the chord
  keyed.reserve(joints.size());
  for (Joint& j : joints) {
    Rational along = 0;
    if (j.at == Joint::At::Inside) {
      const Point a = in.end_of(j.chord, false), b = in.end_of(j.chord, true);
      along = (b.x - a.x) * j.place.x + (b.y - a.y) * j.place.y;
    }
    keyed.emplace_back(std::move(along), std::move(j));
  }
  std::sort(keyed.begin(), keyed.end(), [](const auto& i, const auto& j) {
    return std::tie(i.second.chord, i.second.at, i.first, i.second.place) <
           std::tie(j.second.chord, j.second.at, j.first, j.second.place);
  });
  joints.clear();
  for (auto& [along, j] : keyed) {
    if (joints.empty() || !(joints.back() == j)) joints.push_back(std::move(j));
  }
}

/// The joints of one kind, and what the ledger says of them, at the place of the first.
void append(Joints& result, PointsOnCurves more, const char* what, const SegmentSet& set) {
  if (more.count == 0) return;
  constexpr double kRoundedUp = 1.06;  // of two digits
  const std::size_t first =
      std::min_element(more.joints.begin(), more.joints.end(), [](const Joint& a, const Joint& b) {
        return a.chord < b.chord;
      })->chord;
  result.ledger.push_back({set.sources[set.segment_source[first]],
                           fmt::format("{} {}", more.count, what),
                           fmt::format("{:.2g} units", kRoundedUp * more.farthest)});
  result.joints.insert(result.joints.end(), more.joints.begin(), more.joints.end());
}

}  // namespace

Joints find_joints(const PlacedCurves& placed) {
  Joints result;
  if (placed.curves.empty()) return result;
  const CurvesInPlace in(placed);
  std::vector<Authored> points = authored_points(in);
  std::vector<End> ends = ends_of_curves(in);
  std::vector<std::size_t> tied = take_authored_ends(ends, in, points);
  take_ends_of_curves(ends, in);
  const std::vector<std::size_t> tied_on_lines = take_lines(ends, in);
  tied.insert(tied.end(), tied_on_lines.begin(), tied_on_lines.end());
  for (const std::size_t i : tied) {
    if (ends[i].place) continue;
    const std::size_t chord = in.curves[ends[i].curve].first;
    result.remarks.push_back(make_remark(placed.set.sources[placed.set.segment_source[chord]],
                                         "two places are equally near the end of a curve, "
                                         "which meets neither",
                                         to_text(ends[i].at)));
  }
  append(result, moved_ends(ends, in), "ends of curves by what they meet", placed.set);
  for (const End& end : ends) points.push_back({end.settled(), end.bound, end.curve});
  const ChordTree chords(in);
  append(result, points_on_curves(in, chords, points), "points of curves by ends that lie on them",
         placed.set);
  sort(result.joints, in);
  append(result, crossings_of_curves(in, chords, result.joints),
         "crossings of curves by points of what crosses them", placed.set);
  sort(result.joints, in);
  return result;
}

SegmentSet with_joints(SegmentSet set, const Joints& joints) {
  if (joints.joints.empty() && joints.remarks.empty()) return set;
  SegmentList segments;
  std::vector<SourceId> sources;
  std::vector<double> rounding;
  segments.reserve(set.segments.size() + joints.joints.size());
  sources.reserve(set.segments.size() + joints.joints.size());
  std::vector<std::uint32_t> places;  // of the segments that there were
  auto joint = joints.joints.begin();
  for (std::size_t s = 0; s < set.segments.size(); ++s) {
    const auto n = set.segments.numbers(s);
    places.push_back(static_cast<std::uint32_t>(segments.size()));
    NumberPoint from{n[0], n[1]}, to{n[2], n[3]};
    std::vector<NumberPoint> further;
    for (; joint != joints.joints.end() && joint->chord == s; ++joint) {
      NumberPoint place{joint->place.x, joint->place.y};
      if (joint->at == Joint::At::Inside) {
        further.push_back(std::move(place));
      } else {
        (joint->at == Joint::At::Start ? from : to) = std::move(place);
      }
    }
    further.push_back(std::move(to));
    for (NumberPoint& next : further) {
      if (next == from) continue;
      segments.push_back(std::move(from), next);
      sources.push_back(set.segment_source[s]);
      if (!set.rounding.empty()) rounding.push_back(set.rounding[s]);
      from = std::move(next);
    }
  }
  for (Ring& ring : set.rings) ring.first = places[ring.first];  // rings have no curves
  set.segments = std::move(segments);
  set.segment_source = std::move(sources);
  set.rounding = std::move(rounding);
  set.ledger.insert(set.ledger.end(), joints.ledger.begin(), joints.ledger.end());
  set.remarks.insert(set.remarks.end(), joints.remarks.begin(), joints.remarks.end());
  return set;
}

}  // namespace plumbline
