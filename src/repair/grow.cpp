// A bounded motorcycle graph. Each loose end has a track, straight on and as long as the reach. The
// tracks are arranged with what is near them; on each of them its runner arrives at one vertex
// after the other, at the squared distance from where it started. It stops at the drawing, at a
// vertex that another one reached before, and where several arrive at the same time.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "geometry/box_tree.hpp"
#include "plumbline/arrange.hpp"
#include "repair/growths.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// A vertex where a runner arrives.
struct Arrival {
  Rational time;  ///< squared
  VertexId vertex;
  std::size_t runner;
};

class Race {
 public:
  Race(const Work& work, const Arranged& arranged, const std::vector<Tip>& tips,
       const Rational& reach)
      : tips_(tips), squared_reach_(reach * reach) {
    const std::vector<Segment> tracks = tracks_of(tips, reach);
    SegmentSet near = near_lines(work, arranged, tracks);
    first_track_ = near.segments.size();
    const SourceId source(std::size_t{0});
    for (const Segment& track : tracks) near.add(track, source);
    add_middles(near);
    complex_ = arrange(near);
    collect_arrivals();
  }

  /// Where a runner ends, and whether the drawing was there before.
  struct End {
    Point point;
    bool is_drawn = false;
  };

  /// None for a runner that meets nothing.
  std::vector<std::optional<End>> run() {
    std::vector<VertexId> stop(tips_.size()), kept(tips_.size());
    std::vector<std::size_t> reached(complex_.vertices.size(), kNobody);
    for (std::size_t i = 0; i < arrivals_.size();) {
      std::size_t end = i;  // those that arrive at one vertex at one time
      std::vector<std::size_t> running;
      for (; end < arrivals_.size() && is_together(arrivals_[end], arrivals_[i]); ++end) {
        if (!stop[arrivals_[end].runner].valid()) running.push_back(arrivals_[end].runner);
      }
      const VertexId v = arrivals_[i].vertex;
      i = end;
      if (running.empty()) continue;
      if (is_drawn_[v] != 0 || reached[v] != kNobody || running.size() > 1) {
        for (const std::size_t r : running) stop[r] = v;
        if (is_drawn_[v] == 0 && reached[v] != kNobody) keep(kept[reached[v]], reached[v], v);
      }
      if (reached[v] == kNobody) reached[v] = running.front();
    }
    std::vector<std::optional<End>> result(tips_.size());
    for (std::size_t r = 0; r < tips_.size(); ++r) {
      const VertexId v = stop[r].valid() ? stop[r] : kept[r];
      if (v.valid()) result[r] = End{complex_.vertices[v], is_drawn_[v] != 0};
    }
    return result;
  }

 private:
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  static bool is_together(const Arrival& p, const Arrival& q) {
    return p.vertex == q.vertex && p.time == q.time;
  }

  /// A runner's track stays up to v, and beyond if it did before.
  void keep(VertexId& kept, std::size_t runner, VertexId v) const {
    const Point& start = tips_[runner].point;
    if (!kept.valid() || squared_distance(start, complex_.vertices[kept]) <
                             squared_distance(start, complex_.vertices[v])) {
      kept = v;
    }
  }

  /// The lines that may meet a track, as segments.
  static SegmentSet near_lines(const Work& work, const Arranged& arranged,
                               const std::vector<Segment>& tracks) {
    SegmentSet near;
    const SourceId source = near.add_source({});
    std::vector<BoxD> boxes;
    double largest = 0;
    for (const Segment& track : tracks) {
      const std::array<PointD, 2> ends = {nearest(track.a), nearest(track.b)};
      boxes.push_back(box_of(ends));
      largest = std::max(largest, largest_coordinate(ends));
    }
    for (BoxD& box : boxes) box = grown(box, largest * 0x1p-40);
    const BoxTree tree(boxes);
    for (const LineId id : arranged.line_of) {
      if (tree.meeting(work.rounded(id)).empty()) continue;
      const Line line = work.line(id);
      near.add(Segment{line.a, line.b}, source);
    }
    return near;
  }

  /// Two ends that face each other on one line meet in the middle.
  void add_middles(SegmentSet& near) const {
    const SourceId source(std::size_t{0});
    for (const auto& [t, u] : facing_pairs(tips_)) {
      const Point &p = tips_[t].point, &q = tips_[u].point;
      if (squared_distance(p, q) > squared_reach_) continue;
      near.add_point({(p.x + q.x) / 2, (p.y + q.y) / 2}, source);
    }
  }

  void collect_arrivals() {
    is_drawn_.assign(complex_.vertices.size(), 0);
    std::vector<std::vector<VertexId>> on_track(tips_.size());  // ascending, without the tip
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const Edge edge = complex_.edges[e];
      const auto sources = complex_.edge_sources[e];
      if (sources.front() < first_track_) is_drawn_[edge.tail] = is_drawn_[edge.head] = 1;
      for (const SegmentId s : sources) {
        if (s < first_track_) continue;
        const std::size_t runner = s - first_track_;
        // Edges of a track that runs to the right are met at their heads.
        on_track[runner].push_back(is_forward(tips_[runner].direction) ? edge.head : edge.tail);
      }
    }
    for (std::size_t runner = 0; runner < tips_.size(); ++runner) {
      std::vector<VertexId>& vertices = on_track[runner];
      if (!is_forward(tips_[runner].direction)) std::ranges::reverse(vertices);
      for (const VertexId v : vertices) {
        Rational time = squared_distance(tips_[runner].point, complex_.vertices[v]);
        if (time > squared_reach_) break;
        arrivals_.push_back({std::move(time), v, runner});
        if (is_drawn_[v] != 0) break;  // nobody runs on there
      }
    }
    std::ranges::sort(arrivals_, [](const Arrival& p, const Arrival& q) {
      const int by_time = cmp(p.time, q.time);
      if (by_time != 0) return by_time < 0;
      return std::tie(p.vertex, p.runner) < std::tie(q.vertex, q.runner);
    });
  }

  const std::vector<Tip>& tips_;
  Rational squared_reach_;
  std::size_t first_track_ = 0;
  ExactComplex complex_;
  std::vector<char> is_drawn_;  ///< per vertex
  std::vector<Arrival> arrivals_;
};

/// The line that ends at p, longer: up to q.
Line extended(Line line, const Point& p, const Point& q) {
  (line.a == p ? line.a : line.b) = q;
  return line;
}

/// Two lines on one line, each grown up to where they meet.
void bridge(Work& work, const Growth& growth) {
  const LineId p = work.ending_at(growth.tip.line, growth.tip.point);
  const LineId q = work.ending_at(growth.other->line, growth.other->point);
  const Line first = extended(work.line(p), growth.tip.point, growth.end);
  const Line second = extended(work.line(q), growth.other->point, growth.end);
  std::vector<Line> after = {first, second};
  if (work.is_same_layer(p, q)) after = {united(first, second)};
  work.apply(EditKind::Bridge, growth.tip.point, growth.squared_length, {p, q}, std::move(after));
}

/// To where ends have run.
std::set<Point> grown_ends(const std::vector<Edit>& edits) {
  std::set<Point> result;
  for (const Edit& edit : edits) {
    if (edit.kind != EditKind::Grow) continue;
    const Line &before = edit.before.front(), &after = edit.after.front();
    result.insert(before.a == after.a ? after.b : after.a);
  }
  return result;
}

}  // namespace

std::vector<Growth> growths(const Work& work, const Arranged& arranged, const Rational& reach) {
  std::vector<Growth> result;
  std::vector<Tip> tips = growing_tips(work, arranged);
  // What an end has run to may have gone since; it does not run on.
  const std::set<Point> grown = grown_ends(work.edits());
  std::erase_if(tips, [&](const Tip& tip) { return grown.contains(tip.point); });
  if (tips.empty()) return result;
  std::vector<std::optional<Race::End>> ends = Race(work, arranged, tips, reach).run();
  for (const auto& [t, u] : facing_pairs(tips)) {
    if (!ends[t] || !ends[u] || !(ends[t]->point == ends[u]->point) || ends[t]->is_drawn) continue;
    Rational gap = squared_distance(tips[t].point, tips[u].point);
    if (gap > reach * reach) continue;
    result.push_back({tips[t], tips[u], ends[t]->point, std::move(gap)});
    ends[t] = ends[u] = std::nullopt;
  }
  for (std::size_t t = 0; t < tips.size(); ++t) {
    if (!ends[t]) continue;
    result.push_back(
        {tips[t], std::nullopt, ends[t]->point, squared_distance(tips[t].point, ends[t]->point)});
  }
  return result;
}

void grow(Work& work, const Arranged& arranged, const Rational& reach) {
  for (const Growth& growth : growths(work, arranged, reach)) {
    if (growth.other) {
      bridge(work, growth);
      continue;
    }
    const Tip& tip = growth.tip;
    const LineId id = work.ending_at(tip.line, tip.point);
    work.apply(EditKind::Grow, tip.point, growth.squared_length, {id},
               {extended(work.line(id), tip.point, growth.end)});
  }
}

}  // namespace plumbline::repair_steps
