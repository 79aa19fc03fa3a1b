// Where curves meet what meets them.

#include "structure/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "geometry/point_d.hpp"
#include "geometry/rejected.hpp"
#include "geometry/union_find.hpp"
#include "structure/unit_frame.hpp"

namespace plumbline {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::d2::point_xy<double>;
using Rectangle = bg::model::box<Corner>;
using Entry = std::pair<Rectangle, std::size_t>;
using BoxTree = bg::index::rtree<Entry, bg::index::rstar<16>>;

/// Outweighs the rounding of a few operations in doubles, as a part of the largest coordinate.
constexpr double kSlack = 0x1p-48;

/// An end of a curve, and where it is to be.
struct End {
  std::size_t curve;
  bool is_last;
  Point at;
  double bound;
  std::optional<Point> place = {};
};

/// A point that curves may be joined to, known within `rounding`.
struct Authored {
  Point at;
  double rounding;
};

double distance_of(const Point& p, const Point& q) { return nearest_sqrt(squared_distance(p, q)); }

class JointFinder {
 public:
  explicit JointFinder(const PlacedCurves& placed)
      : placed_(placed), segments_(placed.set.segments) {
    is_chord_.resize(segments_.size());
    for (const Curve& curve : placed_.curves) {
      for (std::size_t i = 0; i < curve.count; ++i) is_chord_[curve.first + i] = true;
    }
    BoxD box{};
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      for (const PointD& p : {rough(i, false), rough(i, true)}) {
        if (i == 0) box = {p, p};
        box.include(p);
      }
    }
    cap_ = kMostJoined * box.longer_side();
    slack_ = kSlack * std::max({-box.low.x, -box.low.y, box.high.x, box.high.y});
    most_rounding_ = 0;
    for (const double r : placed_.rounding) most_rounding_ = std::max(most_rounding_, r);
  }

  Joints run() && {
    collect_ends();
    take_authored_ends();
    take_ends_of_curves();
    take_lines();
    add_ends();
    add_points_on_curves();
    sort();
    tell();
    return std::move(result_);
  }

 private:
  PointD rough(std::size_t segment, bool is_b) const {
    const auto n = segments_.numbers(segment);
    return is_b ? nearest({n[2], n[3]}) : nearest({n[0], n[1]});
  }
  Point end_of(std::size_t segment, bool is_b) const {
    const auto n = segments_.numbers(segment);
    return is_b ? Point{n[2].rational(), n[3].rational()} : Point{n[0].rational(), n[1].rational()};
  }
  Point first_point(const Curve& c) const { return end_of(c.first, false); }
  Point last_point(const Curve& c) const { return end_of(c.first + c.count - 1, true); }
  bool is_closed(const Curve& c) const { return first_point(c) == last_point(c); }
  static Rectangle box_around(const PointD& p, double reach) {
    return {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
  }
  double within(double bound) const { return std::min(bound, cap_); }

  void collect_ends();
  void take_authored_ends();
  void take_ends_of_curves();
  void take_lines();
  void add_ends();
  void add_points_on_curves();
  void sort();
  void tell();
  /// Calls visit(end, i) for the ends without a place near segments that are no chords.
  template <class Visit>
  void for_each_near_line(double reach, Visit visit) const;
  std::vector<Authored> authored_points() const;
  void add_point_on(const Authored& p, const Curve& curve, std::size_t chord);

  const PlacedCurves& placed_;
  const SegmentList& segments_;
  std::vector<bool> is_chord_;
  double cap_ = 0, slack_ = 0, most_rounding_ = 0;
  std::vector<End> ends_;
  Joints result_;
  std::size_t joined_ends_ = 0, joined_points_ = 0;
  double farthest_end_ = 0, farthest_point_ = 0;
};

void JointFinder::collect_ends() {
  for (std::size_t c = 0; c < placed_.curves.size(); ++c) {
    const Curve& curve = placed_.curves[c];
    if (curve.end_bound <= 0 || is_closed(curve)) continue;
    ends_.push_back({c, false, first_point(curve), curve.end_bound});
    ends_.push_back({c, true, last_point(curve), curve.end_bound});
  }
}

template <class Visit>
void JointFinder::for_each_near_line(double reach, Visit visit) const {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (!ends_[i].place) entries.emplace_back(box_around(nearest(ends_[i].at), reach), i);
  }
  if (entries.empty()) return;
  const BoxTree tree(entries);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    if (is_chord_[s]) continue;
    const PointD a = rough(s, false), b = rough(s, true);
    const bg::model::segment<Corner> line({a.x, a.y}, {b.x, b.y});
    for (auto it = tree.qbegin(bg::index::intersects(line)); it != tree.qend(); ++it) {
      visit(it->second, s);
    }
  }
}

/// The authored ends: those of lines, and those of curves that are given by them.
std::vector<Authored> JointFinder::authored_points() const {
  std::vector<Authored> points;
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    if (is_chord_[s]) continue;
    for (const bool is_b : {false, true}) points.push_back({end_of(s, is_b), placed_.rounding[s]});
  }
  for (const Curve& curve : placed_.curves) {
    if (curve.end_bound > 0 || is_closed(curve)) continue;
    points.push_back({first_point(curve), curve.bound});
    points.push_back({last_point(curve), curve.bound});
  }
  return points;
}

void JointFinder::take_authored_ends() {
  if (ends_.empty()) return;
  double most = most_rounding_;
  std::vector<Entry> entries;
  for (const Curve& curve : placed_.curves) most = std::max(most, curve.bound);
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const double reach = within(ends_[i].bound + most) + slack_;
    entries.emplace_back(box_around(nearest(ends_[i].at), reach), i);
  }
  const BoxTree tree(entries);
  struct Choice {
    Rational squared;
    Point place;
    bool is_tied = false;
  };
  std::vector<std::optional<Choice>> choices(ends_.size());
  for (const Authored& p : authored_points()) {
    const PointD at = nearest(p.at);
    for (auto it = tree.qbegin(bg::index::intersects(Corner(at.x, at.y))); it != tree.qend();
         ++it) {
      const End& end = ends_[it->second];
      Rational squared = squared_distance(end.at, p.at);
      if (nearest_sqrt(squared) > within(end.bound + p.rounding)) continue;
      std::optional<Choice>& choice = choices[it->second];
      if (!choice || squared < choice->squared) {
        choice = {std::move(squared), p.at, false};
      } else if (squared == choice->squared && p.at != choice->place) {
        choice->is_tied = true;
      }
    }
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (!choices[i]) continue;
    if (choices[i]->is_tied) {
      const Curve& curve = placed_.curves[ends_[i].curve];
      result_.refused.push_back(
          make_rejected(placed_.set.sources[placed_.set.segment_source[curve.first]],
                        "two ends are equally near the end of a curve, which is left apart",
                        to_text(ends_[i].at)));
    } else {
      ends_[i].place = choices[i]->place;
    }
  }
}

/// Ends of curves that nothing authored is near to, but each other: the place of the sharpest one.
void JointFinder::take_ends_of_curves() {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const double reach = within(2 * ends_[i].bound) + slack_;
    if (!ends_[i].place) entries.emplace_back(box_around(nearest(ends_[i].at), reach), i);
  }
  if (entries.empty()) return;
  const BoxTree tree(entries);
  const auto are_near = [&](const End& a, const End& b) {
    return a.curve != b.curve && distance_of(a.at, b.at) <= within(a.bound + b.bound);
  };
  UnionFind sets(ends_.size());
  for (const auto& [box, i] : entries) {
    const PointD at = nearest(ends_[i].at);
    for (auto it = tree.qbegin(bg::index::intersects(Corner(at.x, at.y))); it != tree.qend();
         ++it) {
      if (it->second != i && are_near(ends_[i], ends_[it->second])) sets.unite(i, it->second);
    }
  }
  std::map<std::size_t, std::size_t> sharpest;  // by set
  const auto is_sharper = [&](std::size_t i, std::size_t j) {
    return std::tie(ends_[i].bound, ends_[i].at) < std::tie(ends_[j].bound, ends_[j].at);
  };
  for (const auto& [box, i] : entries) {
    const auto [found, is_new] = sharpest.try_emplace(sets.find(i), i);
    if (!is_new && is_sharper(i, found->second)) found->second = i;
  }
  for (const auto& [box, i] : entries) {
    const End& best = ends_[sharpest[sets.find(i)]];
    if (ends_[i].at != best.at && are_near(ends_[i], best)) ends_[i].place = best.at;
  }
}

/// An end that is near no other one, but on a line.
void JointFinder::take_lines() {
  double most = 0;
  for (const End& end : ends_) most = std::max(most, end.bound);
  std::map<std::size_t, std::pair<Rational, Point>> nearest_foot;
  for_each_near_line(within(most + most_rounding_) + slack_, [&](std::size_t i, std::size_t s) {
    const End& end = ends_[i];
    const Point a = end_of(s, false), b = end_of(s, true);
    const Rational ux = b.x - a.x, uy = b.y - a.y;
    const Rational along = (ux * (end.at.x - a.x) + uy * (end.at.y - a.y)) / (ux * ux + uy * uy);
    if (along <= 0 || along >= 1) return;
    Point foot{a.x + along * ux, a.y + along * uy};
    Rational squared = squared_distance(foot, end.at);
    if (nearest_sqrt(squared) > within(end.bound + placed_.rounding[s])) return;
    const auto found = nearest_foot.find(i);
    if (found == nearest_foot.end() ||
        std::tie(squared, foot) < std::tie(found->second.first, found->second.second)) {
      nearest_foot[i] = {std::move(squared), std::move(foot)};
    }
  });
  for (auto& [i, foot] : nearest_foot) ends_[i].place = std::move(foot.second);
}

/// An arc stays one: its two ends do not become one point.
void JointFinder::add_ends() {
  for (std::size_t i = 0; i + 1 < ends_.size(); i += 2) {
    End &first = ends_[i], &last = ends_[i + 1];
    const auto at = [](const End& end) { return end.place ? *end.place : end.at; };
    if (at(first) == at(last)) first.place = last.place = std::nullopt;
    for (End* end : {&first, &last}) {
      if (!end->place || *end->place == end->at) continue;
      const Curve& curve = placed_.curves[end->curve];
      const std::size_t chord = end->is_last ? curve.first + curve.count - 1 : curve.first;
      result_.joints.push_back(
          {chord, end->is_last ? Joint::At::End : Joint::At::Start, *end->place});
      ++joined_ends_;
      farthest_end_ = std::max(farthest_end_, distance_of(end->at, *end->place));
    }
  }
}

/// A point within the bound of a curve becomes a vertex of it; or takes the place of one of its
/// own that is as near.
void JointFinder::add_point_on(const Authored& p, const Curve& curve, std::size_t chord) {
  const UnitFrame frame(*curve.ellipse);
  const Point q = frame.in(p.at);
  const Rational excess = q.x * q.x + q.y * q.y - 1;  // about twice what q is off by
  const auto length = [](const Point& u) {
    return std::hypot(nearest_double(u.x), nearest_double(u.y));
  };
  const double longer = std::hypot(length(curve.ellipse->u), length(curve.ellipse->v));
  const double off = std::abs(nearest_double(excess)) / 2 * longer;
  if (off > within(curve.bound + p.rounding)) return;
  const Point a = end_of(chord, false), b = end_of(chord, true);
  if (p.at == a || p.at == b) return;
  const Point qa = frame.in(a), qb = frame.in(b);
  const auto cross = [](const Point& s, const Point& t) {
    return sgn(Rational(s.x * t.y - s.y * t.x));
  };
  const int turn = cross(qa, qb);
  if (turn == 0 || cross(qa, q) != turn || cross(q, qb) != turn) return;
  result_.joints.push_back({chord, Joint::At::Inside, p.at});
  ++joined_points_;
  farthest_point_ = std::max(farthest_point_, off);
}

void JointFinder::add_points_on_curves() {
  std::vector<Entry> entries;
  std::vector<std::size_t> curve_of;  // per entry
  double most = most_rounding_;
  for (const Curve& curve : placed_.curves) most = std::max(most, curve.bound);
  for (std::size_t c = 0; c < placed_.curves.size(); ++c) {
    const Curve& curve = placed_.curves[c];
    if (!curve.ellipse || !UnitFrame::is_proper(*curve.ellipse)) continue;
    const double reach = curve.chord_bound + within(curve.bound + most) + slack_;
    for (std::size_t i = 0; i < curve.count; ++i) {
      const PointD a = rough(curve.first + i, false), b = rough(curve.first + i, true);
      const Rectangle box{{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
                          {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}};
      entries.emplace_back(box, curve.first + i);
      curve_of.push_back(c);
    }
  }
  if (entries.empty()) return;
  std::map<std::size_t, std::size_t> curve_of_chord;
  for (std::size_t i = 0; i < entries.size(); ++i) curve_of_chord[entries[i].second] = curve_of[i];
  const BoxTree tree(entries);
  const auto add_near = [&](const Authored& p, std::size_t own_curve) {
    const PointD at = nearest(p.at);
    for (auto it = tree.qbegin(bg::index::intersects(Corner(at.x, at.y))); it != tree.qend();
         ++it) {
      const std::size_t c = curve_of_chord[it->second];
      if (c != own_curve) add_point_on(p, placed_.curves[c], it->second);
    }
  };
  for (const Authored& p : authored_points()) add_near(p, placed_.curves.size());
  for (const End& end : ends_) add_near({end.place ? *end.place : end.at, end.bound}, end.curve);
}

/// By chord, along it, each place once.
void JointFinder::sort() {
  const auto along = [&](const Joint& j) {
    const Point a = end_of(j.chord, false), b = end_of(j.chord, true);
    return Rational((b.x - a.x) * j.place.x + (b.y - a.y) * j.place.y);
  };
  std::sort(result_.joints.begin(), result_.joints.end(), [&](const Joint& i, const Joint& j) {
    if (i.chord != j.chord) return i.chord < j.chord;
    if (i.at != j.at) return i.at < j.at;
    const int order = cmp(along(i), along(j));
    return order != 0 ? order < 0 : i.place < j.place;
  });
  const auto last = std::unique(result_.joints.begin(), result_.joints.end());
  result_.joints.erase(last, result_.joints.end());
}

void JointFinder::tell() {
  if (result_.joints.empty()) return;
  const auto add = [&](std::size_t count, const char* what, double farthest) {
    if (count == 0) return;
    constexpr double kRoundedUp = 1.06;
    result_.ledger.push_back({{},
                              fmt::format("{} of {}", what, count),
                              fmt::format("{:.2g} units", kRoundedUp * farthest)});
  };
  add(joined_ends_, "ends of curves moved to what they meet, in number", farthest_end_);
  add(joined_points_, "ends", farthest_point_);
}

}  // namespace

Joints find_joints(const PlacedCurves& placed) {
  if (placed.curves.empty()) return {};
  return JointFinder(placed).run();
}

SegmentSet with_joints(SegmentSet set, const Joints& joints) {
  SegmentList segments;
  std::vector<SourceId> sources;
  segments.reserve(set.segments.size() + joints.joints.size());
  auto joint = joints.joints.begin();
  const auto number_point = [](const Point& p) { return NumberPoint{p.x, p.y}; };
  for (std::size_t s = 0; s < set.segments.size(); ++s) {
    const auto n = set.segments.numbers(s);
    NumberPoint a{n[0], n[1]}, b{n[2], n[3]};
    std::vector<NumberPoint> inside;
    for (; joint != joints.joints.end() && joint->chord == s; ++joint) {
      if (joint->at == Joint::At::Start) a = number_point(joint->place);
      if (joint->at == Joint::At::Inside) inside.push_back(number_point(joint->place));
      if (joint->at == Joint::At::End) b = number_point(joint->place);
    }
    inside.push_back(b);
    for (NumberPoint& next : inside) {
      if (next == a) continue;
      segments.push_back(a, next);
      sources.push_back(set.segment_source[s]);
      a = std::move(next);
    }
  }
  set.segments = std::move(segments);
  set.segment_source = std::move(sources);
  set.ledger.insert(set.ledger.end(), joints.ledger.begin(), joints.ledger.end());
  set.rejected.insert(set.rejected.end(), joints.refused.begin(), joints.refused.end());
  return set;
}

}  // namespace plumbline
