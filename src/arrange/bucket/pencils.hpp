#pragma once

// Full buckets: many lines that all but share a direction, or that go through one point
// ("pencils").

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "arrange/bucket/pairs.hpp"
#include "arrange/bucket/prime_field.hpp"

namespace plumbline::bucket {

/// Searches a bucket of many lines. They are sorted across their mean direction, so that parallel
/// ones are not compared. Every point found is remembered: a third line through it makes a pencil,
/// and as no two lines share more than a point, pairs within a pencil need not be tested again.
template <class Kernel>
class Pencils {
 public:
  Pencils(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found)
      : scene_(scene),
        kernel_(scene.kernel),
        box_(scene.buckets.box(bucket)),
        margin_(2 * scene.buckets.margin()),
        found_(found) {}

  void search(std::span<const LineId> lines) {
    sort_across(lines);
    common_.assign((members_.size() + kBlock - 1) / kBlock, 0);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (std::size_t j = i + 1; j < members_.size() && members_[j].low <= members_[i].high; ++j) {
        if (j % kBlock == 0 && (common_[j / kBlock] & members_[i].pencils) != 0) {
          j += kBlock - 1;
        } else if ((members_[i].pencils & members_[j].pencils) == 0) {
          test(i, j);
        }
      }
    }
  }

 private:
  static constexpr std::size_t kBlock = 64;
  static constexpr unsigned kMostPencils = 64;

  /// Where a line lies across the common direction, and which pencils it is in.
  struct Member {
    double low, high;
    LineId line;
    std::uint64_t pencils;
  };

  /// A point where lines meet: the end `end`, or the crossing of s and o.
  struct Common {
    EndId end;
    LineId s, o;
    std::uint32_t crossing;     ///< index into found_.crossings
    bool here;                  ///< whether this bucket records it
    std::uint64_t pencil;       ///< its bit, once it has three lines
    std::size_t first, second;  ///< members
  };

  /// Sorts the lines by their extent across the mean direction, inside this bucket.
  void sort_across(std::span<const LineId> lines) {
    double c = 0, s = 0;  // of the doubled angle, so that opposite directions agree
    for (const LineId line : lines) {
      const Approx& l = scene_.approx[line];
      const double dx = l.bx - l.ax, dy = l.by - l.ay, length2 = dx * dx + dy * dy;
      if (!(length2 > 0)) continue;
      c += (dx * dx - dy * dy) / length2;
      s += 2 * dx * dy / length2;
    }
    const double angle = std::atan2(s, c) / 2;
    const double nx = -std::sin(angle), ny = std::cos(angle);
    members_.reserve(lines.size());
    for (const LineId line : lines) {
      const auto [p, q] = clipped(scene_.approx[line]);
      const double u = nx * p.x + ny * p.y, v = nx * q.x + ny * q.y;
      members_.push_back({std::min(u, v) - margin_, std::max(u, v) + margin_, line, 0});
    }
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
      return a.low != b.low ? a.low < b.low : a.line < b.line;
    });
  }

  /// The ends of the part of a line within the box, widened by the margin; the whole line where
  /// rounding leaves nothing.
  std::pair<PointD, PointD> clipped(const Approx& l) const {
    double t0 = 0, t1 = 1;
    const auto clip = [&](double from, double d, double low, double high) {
      if (d == 0) return;
      double u = (low - margin_ - from) / d, v = (high + margin_ - from) / d;
      if (v < u) std::swap(u, v);
      t0 = std::max(t0, u);
      t1 = std::min(t1, v);
    };
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    clip(l.ax, dx, box_.x0, box_.x1);
    clip(l.ay, dy, box_.y0, box_.y1);
    if (!(t0 <= t1)) return {{l.ax, l.ay}, {l.bx, l.by}};
    return {{l.ax + t0 * dx, l.ay + t0 * dy}, {l.ax + t1 * dx, l.ay + t1 * dy}};
  }

  void test(std::size_t i, std::size_t j) {
    if (members_[j].line < members_[i].line) std::swap(i, j);
    const LineId s = members_[i].line, o = members_[j].line;
    const Relation r = kernel_.relate(s, o);
    if (r.apart()) return;
    EndId end_s = kNone, end_o = kNone;
    if (!r.cross() && !find_ends(s, o, r, end_s, end_o)) return;
    const EndId end = end_s != kNone ? end_s : end_o;
    const PointD p = end != kNone ? scene_.place(end) : scene_.at(s, r.at_s);
    std::size_t& known = at_[key(p)];
    if (known != 0 && goes_through(s, commons_[known - 1]) &&
        goes_through(o, commons_[known - 1])) {
      add(commons_[known - 1], i, end_s);
      add(commons_[known - 1], j, end_o);
      return;
    }
    // The lines that make a point known may be others in the bucket next door, and the point
    // rounded otherwise: near the border, both record it.
    const bool here = box_.x0 - margin_ <= p.x && p.x <= box_.x1 + margin_ &&
                      box_.y0 - margin_ <= p.y && p.y <= box_.y1 + margin_;
    const auto crossing = static_cast<std::uint32_t>(found_.crossings.size());
    commons_.push_back({end, s, o, crossing, here, 0, i, j});
    if (known == 0) known = commons_.size();
    if (end != kNone) {
      record(commons_.back(), s, end_s);
      record(commons_.back(), o, end_o);
    } else if (here) {
      add_crossing(found_, s, o, r.at_s, r.at_o, r.b_to_s);
    }
  }

  std::uint64_t key(const PointD& p) const {
    const double width = 4 * margin_;
    const auto cell = [&](double v) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / width)));
    };
    return margin_ > 0 ? prime_field::key(cell(p.x), cell(p.y)) : 0;
  }

  /// The ends of two lines that do not cross in the interior of both but are not apart, at their
  /// common point; false if they have none that matters.
  bool find_ends(LineId s, LineId o, const Relation& r, EndId& end_s, EndId& end_o) const {
    const bool s_is_point = kernel_.is_point(s), o_is_point = kernel_.is_point(o);
    if (s_is_point || o_is_point) {
      if (s_is_point && o_is_point) return false;
      (s_is_point ? end_s : end_o) = first_end(s_is_point ? s : o);
      return is_within(s_is_point ? end_s : end_o, s_is_point ? o : s);
    }
    if (r.a_to_s == 0 && r.b_to_s == 0) return false;  // on one supporting line
    if (r.a_to_s == 0) end_o = first_end(o);
    if (r.b_to_s == 0) end_o = last_end(o);
    if (r.a_to_o == 0) end_s = first_end(s);
    if (r.b_to_o == 0) end_s = last_end(s);
    return true;
  }
  /// Whether an end on the line through s is strictly inside s.
  bool is_within(EndId end, LineId s) const {
    return kernel_.compare(first_end(s), end) < 0 && kernel_.compare(end, last_end(s)) < 0;
  }

  /// Whether the supporting line of a line has the common point.
  bool goes_through(LineId line, const Common& c) const {
    if (line == c.s || line == c.o) return true;
    if (c.end == kNone) {
      return !kernel_.is_point(line) && kernel_.side_of_crossing(line, c.s, c.o) == 0;
    }
    return kernel_.is_point(line) ? kernel_.compare(first_end(line), c.end) == 0
                                  : kernel_.side(line, c.end) == 0;
  }

  /// Adds a member, which has `end` there if it does not go on, to the lines through a point.
  void add(Common& c, std::size_t member, EndId end) {
    if (member == c.first || member == c.second) return;
    if (c.pencil != 0 && (members_[member].pencils & c.pencil) != 0) return;
    if (c.pencil == 0 && pencil_count_ < kMostPencils) {
      c.pencil = std::uint64_t{1} << pencil_count_++;
      mark(c.first, c.pencil);
      mark(c.second, c.pencil);
    }
    if (c.pencil != 0) mark(member, c.pencil);
    record(c, members_[member].line, end);
  }

  void record(const Common& c, LineId line, EndId end) {
    if (!c.here) return;
    if (c.end != kNone) {
      // Ends at one point are known to be the same.
      if (end == kNone) {
        found_.touches.push_back({line, c.end, scene_.along(line, scene_.place(c.end))});
      }
    } else if (end != kNone) {
      found_.touches.push_back({c.s, end, scene_.along(c.s, scene_.place(end))});
    } else {
      found_.throughs.push_back({line, c.crossing, kernel_.parameter(line, cutter(line, c))});
    }
  }
  /// Of the lines of a crossing one that is not parallel to the line.
  LineId cutter(LineId line, const Common& c) const {
    return kernel_.compare_directions(line, c.s) != 0 ? c.s : c.o;
  }

  void mark(std::size_t member, std::uint64_t pencil) {
    members_[member].pencils |= pencil;
    const std::size_t first = member / kBlock * kBlock;
    std::uint64_t common = ~std::uint64_t{0};
    for (std::size_t i = first; i < std::min(first + kBlock, members_.size()); ++i) {
      common &= members_[i].pencils;
    }
    common_[member / kBlock] = common;
  }

  const Scene<Kernel>& scene_;
  const Kernel& kernel_;
  Box box_;
  double margin_;
  Meetings& found_;
  std::vector<Member> members_;
  std::vector<std::uint64_t>
      common_;  ///< per block of members, the pencils that all of them are in
  std::vector<Common> commons_;
  std::unordered_map<std::uint64_t, std::size_t> at_;  ///< by place: 1 + index into commons_
  unsigned pencil_count_ = 0;
};

}  // namespace plumbline::bucket
