// Goes through the pairs that the published pipeline intersects and compares what it did with
// where they meet.

#include "engines/inters/explain/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "geometry/point_d.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

using Kind = MissedMeeting::Kind;

/// Sine of an angle below which two segments count as parallel.
constexpr double kParallel = 1e-12;
/// Of a quantum: a parameter was rounded to its neighbour if it is no further than half of it.
constexpr double kRounded = 0.6;

double cross(const PointD& o, const PointD& p, const PointD& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}
double length(const SegmentD& s) { return distance(s.a, s.b); }

/// Of the foot of p on the line of s.
double parameter_of(const SegmentD& s, const PointD& p) {
  const double x = s.b.x - s.a.x, y = s.b.y - s.a.y;
  return ((p.x - s.a.x) * x + (p.y - s.a.y) * y) / (x * x + y * y);
}

bool is_apart(const lar::Box& s, const lar::Box& t) {
  return t[2] < s[0] || s[2] < t[0] || t[3] < s[1] || s[3] < t[1];
}

class Search {
 public:
  explicit Search(const Trace& trace)
      : trace_(trace),
        vcode_(trace.options.decimals),
        quantum_(std::pow(10, -trace.options.decimals)) {
    std::map<std::pair<PointD, PointD>, std::size_t> fragments;
    for (std::size_t f = 0; f < trace.fragments.size(); ++f) {
      fragments[{trace.fragments[f].segment.a, trace.fragments[f].segment.b}] = f;
    }
    for (const SegmentD& line : trace.lines) {
      const auto [a, b] = vcode_.quantised(line);
      const auto found = fragments.find({a, b});
      fragment_of_.push_back(found == fragments.end() ? 0 : found->second);
    }
  }

  std::vector<MissedMeeting> run() {
    if (trace_.fragments.empty()) return {};
    for (std::size_t h = 0; h < trace_.lines.size(); ++h) {
      for (const SegmentId k : trace_.buckets[h]) {
        if (k <= h || is_apart(trace_.boxes[h], trace_.boxes[k])) continue;
        look_at(h, k);
      }
    }
    return std::move(found_);
  }

 private:
  void look_at(std::size_t h, std::size_t k) {
    const SegmentD& s = trace_.lines[h];
    const SegmentD& t = trace_.lines[k];
    const double product = length(s) * length(t);
    if (product == 0) return;
    const PointD moved{t.b.x - t.a.x + s.a.x, t.b.y - t.a.y + s.a.y};
    const double determinant = cross(s.a, s.b, moved);
    if (std::abs(determinant) <= kParallel * product) {
      along(h, k);
      along(k, h);
      return;
    }
    const PointD back{t.a.x - s.a.x, t.a.y - s.a.y};
    const double on_s = (back.x * (t.b.y - t.a.y) - back.y * (t.b.x - t.a.x)) / determinant;
    const double on_t = (back.x * (s.b.y - s.a.y) - back.y * (s.b.x - s.a.x)) / determinant;
    if (!is_within(s, on_s) || !is_within(t, on_t)) return;
    compare(h, on_s, k, on_t);
  }

  bool is_within(const SegmentD& s, double parameter) const {
    const double reach = trace_.options.radius / length(s);
    return -reach <= parameter && parameter <= 1 + reach;
  }

  /// The ends of segment k within segment h, along it.
  void along(std::size_t h, std::size_t k) {
    const SegmentD& s = trace_.lines[h];
    const double radius = trace_.options.radius;
    for (const PointD& end : {trace_.lines[k].a, trace_.lines[k].b}) {
      if (std::abs(cross(s.a, s.b, end)) > radius * length(s)) continue;
      const double parameter = parameter_of(s, end);
      if (parameter <= 0 || parameter >= 1 || end == s.a || end == s.b) continue;
      add(Kind::Parallel, h, k, end, 0);
    }
  }

  /// The vertex where the segment is cut at the parameter, up to rounding.
  std::optional<PointD> cut(std::size_t h, double parameter) const {
    const Fragment& fragment = trace_.fragments[fragment_of_[h]];
    const double reach =
        std::max(kRounded * quantum_, trace_.options.radius / length(trace_.lines[h]));
    double best = std::abs(parameter) < std::abs(parameter - 1) ? 0 : 1;
    const auto& all = fragment.parameters;
    const auto above = std::lower_bound(all.begin(), all.end(), parameter);
    for (auto it = above == all.begin() ? above : above - 1; it != all.end() && it <= above; ++it) {
      if (std::abs(*it - parameter) < std::abs(best - parameter)) best = *it;
    }
    if (std::abs(best - parameter) > reach) return std::nullopt;
    if (best == 0) return fragment.segment.a;
    if (best == 1) return fragment.segment.b;
    return vcode_.quantised(point_at(fragment.segment, best));
  }

  void compare(std::size_t h, double on_s, std::size_t k, double on_t) {
    const auto cut_of_s = cut(h, on_s), cut_of_t = cut(k, on_t);
    if (cut_of_s && cut_of_t) {
      if (*cut_of_s != *cut_of_t) add(Kind::Apart, h, k, *cut_of_s, distance(*cut_of_s, *cut_of_t));
      return;
    }
    const SegmentD& s = trace_.lines[h];
    const SegmentD& t = trace_.lines[k];
    // The end nearest to the other segment, if it is a junction.
    if (std::min(std::abs(on_s), std::abs(on_s - 1)) * length(s) <= trace_.options.radius) {
      return junction(h, k, std::abs(on_s) < std::abs(on_s - 1) ? s.a : s.b);
    }
    if (std::min(std::abs(on_t), std::abs(on_t - 1)) * length(t) <= trace_.options.radius) {
      return junction(k, h, std::abs(on_t) < std::abs(on_t - 1) ? t.a : t.b);
    }
    add(Kind::Overshoot, h, k, point_at(s, on_s), 0);
  }

  /// Segment h ends at segment k and was not joined to it.
  void junction(std::size_t h, std::size_t k, const PointD& end) {
    const SegmentD& t = trace_.lines[k];
    if (orientation(exact(t.a), exact(t.b), exact(end)) == 0) {
      return add(Kind::Overshoot, h, k, end, 0);
    }
    const Rational squared = squared_distance(exact(end), exact(t.a), exact(t.b));
    add(Kind::NearMiss, h, k, end, std::sqrt(nearest_double(squared)));
  }

  void add(Kind kind, std::size_t h, std::size_t k, const PointD& where, double apart) {
    found_.push_back({kind, SegmentId(h), SegmentId(k), where, apart});
  }

  const Trace& trace_;
  const Vcode vcode_;
  const double quantum_;
  std::vector<std::size_t> fragment_of_;  ///< per line
  std::vector<MissedMeeting> found_;
};

template <class Accept>
const MissedMeeting* nearest_of(const std::vector<MissedMeeting>& meetings,
                                const std::vector<std::pair<SegmentId, std::size_t>>& by_segment,
                                const PointD& p, std::span<const SegmentId> segments,
                                const Accept& accept) {
  constexpr std::size_t kMostSegments = 64;  // a pencil's centre lies on all of its lines
  const MissedMeeting* result = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentId s : segments.first(std::min(segments.size(), kMostSegments))) {
    for (auto it =
             std::lower_bound(by_segment.begin(), by_segment.end(), std::pair(s, std::size_t{0}));
         it != by_segment.end() && it->first == s; ++it) {
      const MissedMeeting& meeting = meetings[it->second];
      const double away = distance(meeting.where, p);
      if (away >= least || !accept(meeting)) continue;
      least = away;
      result = &meeting;
    }
  }
  return result;
}

}  // namespace

Meetings::Meetings(const Trace& trace) : meetings_(Search(trace).run()) {
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    for (const SegmentId s : {meetings_[i].first, meetings_[i].second}) {
      by_segment_.emplace_back(s, i);
    }
  }
  std::sort(by_segment_.begin(), by_segment_.end());
}

const MissedMeeting* Meetings::nearest_to(const PointD& p,
                                          std::span<const SegmentId> segments) const {
  return nearest_of(meetings_, by_segment_, p, segments, [](const auto&) { return true; });
}

const MissedMeeting* Meetings::near_miss(const PointD& p,
                                         std::span<const SegmentId> segments) const {
  return nearest_of(meetings_, by_segment_, p, segments,
                    [](const MissedMeeting& m) { return m.kind == Kind::NearMiss; });
}

}  // namespace plumbline::inters
