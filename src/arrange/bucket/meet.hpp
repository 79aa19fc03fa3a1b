#pragma once

// Step 3: what meets in each bucket. Brute force over the pairs of lines in a bucket, save that in
// a full one, lines are first sorted across their common direction, and those that go through one
// point are recognised together ("pencils").

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "arrange/bucket/buckets.hpp"

namespace plumbline::bucket {

/// An end point in the interior of a line.
struct Touch {
  LineId line;
  std::uint32_t vertex;  ///< of the end point
  double at;
};

/// A line that goes through a crossing of two others.
struct Through {
  LineId line;
  std::uint32_t crossing;  ///< index into Meetings::crossings
  double at;
};

struct Meetings {
  std::vector<Crossing> crossings;
  std::vector<Touch> touches;
  std::vector<Through> throughs;
  std::vector<LineId> overlapping;  ///< lines that share more than a point with another
};

template <class Kernel>
class BucketMeetings {
 public:
  /// `vertex`: per end its vertex. Two ends have the same vertex if they are the same point.
  BucketMeetings(const Kernel& kernel, std::span<const Approx> approx,
                 std::span<const std::uint32_t> vertex, const Buckets& buckets)
      : kernel_(kernel), approx_(approx), vertex_(vertex), buckets_(buckets) {}

  void find(std::size_t bucket) {
    bucket_ = bucket;
    const std::span<const LineId> lines = buckets_.lines(bucket);
    if (lines.size() <= kFew) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = i + 1; j < lines.size(); ++j) pair(lines[i], lines[j]);
      }
    } else {
      find_among_many(lines);
    }
  }
  Meetings take() { return std::move(found_); }

 private:
  static constexpr std::size_t kFew = 24;
  static constexpr std::size_t kPencil =
      16;  ///< fewer lines through a point are taken pair by pair
  static constexpr std::size_t kMostPencils = 32;
  static constexpr std::size_t kSamples = 8;

  /// A line of a full bucket: where it lies across the common direction, and which pencils it is
  /// in.
  struct Member {
    double low, high;
    LineId line;
    std::uint32_t pencils;
  };

  bool boxes_meet(LineId s, LineId o) const {
    const Approx &l = approx_[s], &m = approx_[o];
    return l.ax <= m.bx && m.ax <= l.bx && std::min(l.ay, l.by) <= std::max(m.ay, m.by) &&
           std::min(m.ay, m.by) <= std::max(l.ay, l.by);
  }
  bool is_point(LineId s) const { return vertex_[first_end(s)] == vertex_[last_end(s)]; }
  bool is_here(double x, double y) const { return buckets_.bucket_at(x, y) == bucket_; }
  PointD at(LineId s, double t) const {
    const Approx& l = approx_[s];
    return {l.ax + t * (l.bx - l.ax), l.ay + t * (l.by - l.ay)};
  }

  /// The parameter along s of its crossing with o, given the orientations of its ends to o.
  double parameter(const Value& a, const Value& b, LineId s, LineId o) const {
    constexpr double kNormal = std::numeric_limits<double>::min();
    if (a.magnitude < kNormal || b.magnitude < kNormal) return kernel_.rounded_parameter(s, o);
    return a.magnitude / (a.magnitude + b.magnitude);
  }
  double parameter(LineId s, LineId o) const {
    return parameter(kernel_.orientation(o, first_end(s)), kernel_.orientation(o, last_end(s)), s,
                     o);
  }

  /// What two lines have in common. The crossing is computed in the same way in every bucket, so
  /// just one of them has it.
  void pair(LineId s, LineId o) {
    if (!boxes_meet(s, o)) return;
    if (o < s) std::swap(s, o);
    const Value oa = kernel_.orientation(s, first_end(o)), ob = kernel_.orientation(s, last_end(o));
    if (oa.sign == ob.sign && oa.sign != 0) return;
    const Value sa = kernel_.orientation(o, first_end(s)), sb = kernel_.orientation(o, last_end(s));
    if (sa.sign == sb.sign && sa.sign != 0) return;
    if (oa.sign * ob.sign < 0 && sa.sign * sb.sign < 0) {
      const double t = parameter(sa, sb, s, o);
      const PointD p = at(s, t);
      if (is_here(p.x, p.y)) found_.crossings.push_back({s, o, t, parameter(oa, ob, o, s)});
      return;
    }
    if (is_point(s) && is_point(o)) return;
    if (!is_point(s)) {
      if (oa.sign == 0) touch(s, first_end(o));
      if (ob.sign == 0 && !is_point(o)) touch(s, last_end(o));
    }
    if (!is_point(o)) {
      if (sa.sign == 0) touch(o, first_end(s));
      if (sb.sign == 0 && !is_point(s)) touch(o, last_end(s));
    }
    const bool collinear = oa.sign == 0 && ob.sign == 0 && sa.sign == 0 && sb.sign == 0;
    if (collinear && !is_point(s) && !is_point(o) &&
        kernel_.compare(first_end(s), last_end(o)) < 0 &&
        kernel_.compare(first_end(o), last_end(s)) < 0) {
      found_.overlapping.push_back(s);
      found_.overlapping.push_back(o);
    }
  }

  /// An end on the line through s: a touch if strictly inside s, reported in the end's bucket.
  void touch(LineId s, EndId end) {
    if (kernel_.compare(first_end(s), end) >= 0 || kernel_.compare(end, last_end(s)) >= 0) return;
    const Approx& m = approx_[line_of(end)];
    const double x = is_last(end) ? m.bx : m.ax, y = is_last(end) ? m.by : m.ay;
    if (!is_here(x, y)) return;
    found_.touches.push_back({s, vertex_[end], along(s, x, y)});
  }

  /// The parameter of a point on s.
  double along(LineId s, double x, double y) const {
    const Approx& l = approx_[s];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    return std::abs(dx) >= std::abs(dy) ? (x - l.ax) / dx : (y - l.ay) / dy;
  }

  void find_among_many(std::span<const LineId> lines) {
    std::vector<Member> members = sorted_across(lines);
    find_pencils(members);
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = i + 1; j < members.size() && members[j].low <= members[i].high; ++j) {
        if ((members[i].pencils & members[j].pencils) != 0) continue;
        pair(members[i].line, members[j].line);
      }
    }
  }

  /// The lines sorted by their extent across the mean direction, inside this bucket.
  std::vector<Member> sorted_across(std::span<const LineId> lines) const {
    const Box& box = buckets_.box(bucket_);
    const double margin = buckets_.margin();
    double c = 0, s = 0;  // of the doubled angle, so that opposite directions agree
    for (const LineId line : lines) {
      const Approx& l = approx_[line];
      const double dx = l.bx - l.ax, dy = l.by - l.ay, length2 = dx * dx + dy * dy;
      if (!(length2 > 0)) continue;
      c += (dx * dx - dy * dy) / length2;
      s += 2 * dx * dy / length2;
    }
    const double angle = std::atan2(s, c) / 2;
    const double nx = -std::sin(angle), ny = std::cos(angle);
    std::vector<Member> members;
    for (const LineId line : lines) {
      const auto [p, q] = clipped(approx_[line], box, margin);
      const double u = nx * p.x + ny * p.y, v = nx * q.x + ny * q.y;
      members.push_back({std::min(u, v) - 2 * margin, std::max(u, v) + 2 * margin, line, 0});
    }
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
      return a.low != b.low ? a.low < b.low : a.line < b.line;
    });
    return members;
  }

  /// The ends of the part of a line within the box, widened by twice the margin; the whole line
  /// where rounding leaves nothing.
  static std::pair<PointD, PointD> clipped(const Approx& l, const Box& box, double margin) {
    double t0 = 0, t1 = 1;
    const auto clip = [&](double from, double d, double low, double high) {
      if (d == 0) return;
      double u = (low - 2 * margin - from) / d, v = (high + 2 * margin - from) / d;
      if (v < u) std::swap(u, v);
      t0 = std::max(t0, u);
      t1 = std::min(t1, v);
    };
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    clip(l.ax, dx, box.x0, box.x1);
    clip(l.ay, dy, box.y0, box.y1);
    if (!(t0 <= t1)) return {{l.ax, l.ay}, {l.bx, l.by}};
    return {{l.ax + t0 * dx, l.ay + t0 * dy}, {l.ax + t1 * dx, l.ay + t1 * dy}};
  }

  /// Looks at the crossings of a few pairs for one that many other lines go through.
  void find_pencils(std::vector<Member>& members) {
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < kSamples && next < kMostPencils; ++k) {
      // Any fixed choice of pairs serves: the pairs of a pencil are most pairs, or it does not
      // matter.
      const std::size_t n = members.size();
      const Member& first = members[(2 * k + 1) * n / (2 * kSamples + 2)];
      const Member& second = members[(2 * k + 3) * n / (2 * kSamples + 2)];
      if (first.line == second.line || (first.pencils & second.pencils) != 0) continue;
      if (!cross(first.line, second.line)) continue;
      if (add_pencil(members, first.line, second.line, 1U << next)) ++next;
    }
  }

  /// Whether s and o cross in the interior of both.
  bool cross(LineId s, LineId o) const {
    return boxes_meet(s, o) && kernel_.side(s, first_end(o)) * kernel_.side(s, last_end(o)) < 0 &&
           kernel_.side(o, first_end(s)) * kernel_.side(o, last_end(s)) < 0;
  }

  bool add_pencil(std::vector<Member>& members, LineId s, LineId o, std::uint32_t bit) {
    const PointD p = at(s, parameter(s, o));
    std::vector<Member*> pencil;
    for (Member& m : members) {
      if (goes_through(m.line, s, o, p)) pencil.push_back(&m);
    }
    if (pencil.size() < kPencil || 8 * pencil.size() < members.size()) return false;
    for (Member* m : pencil) m->pencils |= bit;
    const Box& box = buckets_.box(bucket_);
    const double margin = 2 * buckets_.margin();
    if (box.x0 - margin <= p.x && p.x <= box.x1 + margin && box.y0 - margin <= p.y &&
        p.y <= box.y1 + margin) {
      report(pencil, s, o);
    }
    pair_collinear(pencil);
    return true;
  }

  /// Whether a line has the crossing of s and o, which is near p, in its interior or at an end.
  bool goes_through(LineId line, LineId s, LineId o, const PointD& p) const {
    if (line == s || line == o) return true;
    if (is_point(line)) return false;
    const Approx& l = approx_[line];
    const double margin = 2 * buckets_.margin();
    const auto [bottom, top] = std::minmax(l.ay, l.by);
    if (p.x < l.ax - margin || p.x > l.bx + margin || p.y < bottom - margin || p.y > top + margin) {
      return false;
    }
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double across = dx * (p.y - l.ay) - dy * (p.x - l.ax);
    if (std::abs(across) > 2 * margin * (std::abs(dx) + std::abs(dy))) return false;
    if (kernel_.side_of_crossing(line, s, o) != 0) return false;
    // On its line; within it if its ends are not strictly on one side of s, or of o if s is
    // parallel.
    const LineId c = cutter(line, s, o);
    return kernel_.side(c, first_end(line)) * kernel_.side(c, last_end(line)) <= 0;
  }
  /// Of s and o one that is not parallel to the line.
  LineId cutter(LineId line, LineId s, LineId o) const {
    return line != s && kernel_.compare_directions(line, s) != 0 ? s : o;
  }

  /// One meeting for the pencil: the vertex of an end there, or else the crossing of s and o.
  void report(const std::vector<Member*>& pencil, LineId s, LineId o) {
    std::optional<EndId> end;
    std::vector<LineId> inside;
    for (const Member* m : pencil) {
      const LineId line = m->line;
      bool ends_here = false;
      for (const EndId e : {first_end(line), last_end(line)}) {
        if (line == s || line == o || kernel_.side(cutter(line, s, o), e) != 0) continue;
        end = e;
        ends_here = true;
      }
      if (!ends_here) inside.push_back(line);
    }
    const auto crossing = static_cast<std::uint32_t>(found_.crossings.size());
    if (!end) found_.crossings.push_back({s, o, parameter(s, o), parameter(o, s)});
    for (const LineId line : inside) {
      if (end) {
        const Approx& m = approx_[line_of(*end)];
        found_.touches.push_back(
            {line, vertex_[*end],
             is_last(*end) ? along(line, m.bx, m.by) : along(line, m.ax, m.ay)});
      } else if (line != s && line != o) {
        found_.throughs.push_back({line, crossing, parameter(line, cutter(line, s, o))});
      }
    }
  }

  /// Lines of a pencil have no other common point, unless they are collinear.
  void pair_collinear(std::vector<Member*>& pencil) {
    std::sort(pencil.begin(), pencil.end(), [&](const Member* a, const Member* b) {
      const int turn = kernel_.compare_directions(a->line, b->line);
      return turn != 0 ? turn > 0 : a->line < b->line;
    });
    for (std::size_t i = 0; i < pencil.size(); ++i) {
      for (std::size_t j = i + 1;
           j < pencil.size() && kernel_.compare_directions(pencil[i]->line, pencil[j]->line) == 0;
           ++j) {
        pair(pencil[i]->line, pencil[j]->line);
      }
    }
  }

  const Kernel& kernel_;
  std::span<const Approx> approx_;
  std::span<const std::uint32_t> vertex_;
  const Buckets& buckets_;
  std::size_t bucket_ = 0;
  Meetings found_;
};

}  // namespace plumbline::bucket
