#pragma once

// Full buckets: many lines that all but share a direction, or that go through one point
// ("pencils").

#include <algorithm>
#include <bit>
#include <cmath>

#include "arrange/bucket/pairs.hpp"
#include "arrange/bucket/split.hpp"

namespace plumbline::bucket {

/// Searches a bucket of many lines. They are sorted across their mean direction, so that parallel
/// ones are not compared. Where a line meets two others in one place, there is a pencil; as no two
/// lines share more than a point, pairs within a pencil need not be tested again.
template <class Kernel>
class Pencils {
 public:
  Pencils(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found)
      : scene_(scene),
        kernel_(scene.kernel),
        pairs_(scene, bucket, found),
        box_(scene.buckets.box(bucket)),
        found_(found) {}

  void search(std::span<const LineId> lines) {
    sort_across(lines);
    common_.assign((members_.size() + kBlock - 1) / kBlock, 0);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      row_.clear();
      for (std::size_t j = i + 1; j < members_.size() && members_[j].low <= members_[i].high; ++j) {
        if (j % kBlock == 0 && (common_[j / kBlock] & members_[i].pencils) != 0) {
          j += kBlock - 1;
        } else if ((members_[i].pencils & members_[j].pencils) == 0) {
          test(i, j);
        }
      }
      if (row_.empty()) continue;
      record_row(i);
      if (all_in_one_pencil()) return;
    }
  }

 private:
  static constexpr std::size_t kBlock = 64;
  static constexpr std::size_t kMostPencils = 64;

  /// Where a line lies across the common direction, and which pencils it is in.
  struct Member {
    double low, high;
    LineId line;
    std::uint64_t pencils;  ///< a bit each
  };

  /// Where a member meets another.
  struct Meeting {
    double at;             ///< parameter along the member
    std::size_t other;     ///< member
    Relation relation;     ///< of the lesser line to the greater
    EndId end, end_other;  ///< the ends that the two have there, if any
    EndId any_end() const { return end != kNone ? end : end_other; }
  };

  /// Lines through one point: the end `end`, or else the crossing of s and o.
  struct Pencil {
    EndId end;
    LineId s, o;
    std::uint32_t crossing;  ///< index into found_.crossings
    bool here;               ///< whether this bucket records it
    PointD at;
  };

  /// Sorts the lines by their extent across the mean direction, inside this bucket.
  void sort_across(std::span<const LineId> lines) {
    const PointD normal = mean_normal(lines, scene_.approx);
    members_.reserve(lines.size());
    for (const LineId line : lines) margin_ = std::max(margin_, 2 * scene_.margin(line));
    for (const LineId line : lines) {
      const auto [p, q] = ends_of(clipped(line, scene_.approx, box_, margin_), scene_.approx);
      const double u = normal.x * p.x + normal.y * p.y, v = normal.x * q.x + normal.y * q.y;
      const double margin = 2 * scene_.margin(line);
      members_.push_back({std::min(u, v) - margin, std::max(u, v) + margin, line, 0});
    }
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
      return a.low != b.low ? a.low < b.low : a.line < b.line;
    });
  }

  void test(std::size_t i, std::size_t j) {
    const LineId line = members_[i].line, other = members_[j].line;
    const LineId s = std::min(line, other), o = std::max(line, other);
    const Relation r = kernel_.relate(s, o);
    if (r.apart()) return;
    EndId end_s = kNone, end_o = kNone;
    if (!r.cross() && !find_ends(s, o, r, end_s, end_o)) return;
    Meeting meeting{0, j, r, line == s ? end_s : end_o, line == s ? end_o : end_s};
    if (meeting.end != kNone) {
      meeting.at = is_last(meeting.end) ? 1 : 0;
    } else if (meeting.end_other != kNone) {
      meeting.at = scene_.along(line, scene_.place(meeting.end_other));
    } else {
      meeting.at = line == s ? r.at_s : r.at_o;
    }
    row_.push_back(meeting);
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

  /// Records the meetings of a member, those in one place together.
  void record_row(std::size_t member) {
    const LineId line = members_[member].line;
    const double error = scene_.parameter_error(line);
    const auto compare = [&](const Meeting& m, const Meeting& n) {
      return compare_places(kernel_, line, {m.any_end(), members_[m.other].line},
                            {n.any_end(), members_[n.other].line});
    };
    std::sort(row_.begin(), row_.end(), [&](const Meeting& m, const Meeting& n) {
      if (m.at + error < n.at) return true;
      if (n.at + error < m.at) return false;
      return compare(m, n) < 0;
    });
    for (std::size_t i = 0; i < row_.size();) {
      std::size_t j = i + 1;
      while (j < row_.size() && !(row_[j].at > row_[i].at + error) &&
             compare(row_[i], row_[j]) == 0) {
        ++j;
      }
      record_place(member, {row_.data() + i, j - i});
      i = j;
    }
  }

  void record_place(std::size_t member, std::span<const Meeting> place) {
    const LineId line = members_[member].line;
    if (const std::size_t known = find_pencil(member, place.front()); known < pencils_.size()) {
      for (const Meeting& m : place) join(known, m);
    } else if (place.size() > 1 && pencils_.size() < kMostPencils) {
      mark(member, pencils_.size());
      add_pencil(line, place);
    } else {
      for (const Meeting& m : place) pairs_.record(line, members_[m.other].line, m.relation);
    }
  }

  /// A pencil that a member is in, and another that it meets as well. Only those nearby are looked
  /// at: a miss costs time, never a meeting.
  std::size_t find_pencil(std::size_t member, const Meeting& m) const {
    constexpr double kNear = 1e-6;
    const LineId line = members_[member].line, other = members_[m.other].line;
    for (std::uint64_t rest = members_[member].pencils; rest != 0; rest &= rest - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(rest));
      if (std::abs(scene_.along(line, pencils_[k].at) - m.at) > kNear) continue;
      if (goes_through(other, pencils_[k])) return k;
    }
    return pencils_.size();
  }
  /// Whether the supporting line of a line has the point of a pencil.
  bool goes_through(LineId line, const Pencil& p) const {
    if (kernel_.is_point(line)) {
      return p.end != kNone ? kernel_.compare(first_end(line), p.end) == 0
                            : kernel_.side(p.s, first_end(line)) == 0 &&
                                  kernel_.side(p.o, first_end(line)) == 0;
    }
    return p.end != kNone ? kernel_.side(line, p.end) == 0
                          : kernel_.side_of_crossing(line, p.s, p.o) == 0;
  }

  void mark(std::size_t member, std::size_t pencil) {
    members_[member].pencils |= std::uint64_t{1} << pencil;
    const std::size_t first = member / kBlock * kBlock;
    std::uint64_t common = ~std::uint64_t{0};
    for (std::size_t i = first; i < std::min(first + kBlock, members_.size()); ++i) {
      common &= members_[i].pencils;
    }
    common_[member / kBlock] = common;
  }

  /// A pencil of the line and all that it meets in one place. Its vertex is an end there, or else
  /// the crossing with the first. Lines that are not in the bucket next door may make the point
  /// known there, and rounded otherwise: near the border, both buckets record it.
  void add_pencil(LineId line, std::span<const Meeting> place) {
    const Meeting& first = place.front();
    const LineId other = members_[first.other].line;
    Pencil pencil{kNone, line, other, static_cast<std::uint32_t>(found_.crossings.size()),
                  false, {}};
    for (const Meeting& m : place) pencil.end = pencil.end != kNone ? pencil.end : m.any_end();
    const PointD p = pencil.end != kNone ? scene_.place(pencil.end) : scene_.at(line, first.at);
    pencil.at = p;
    pencil.here = box_.x0 - margin_ <= p.x && p.x <= box_.x1 + margin_ &&
                  box_.y0 - margin_ <= p.y && p.y <= box_.y1 + margin_;
    pencils_.push_back(pencil);
    if (pencil.end == kNone) {
      if (pencil.here) pairs_.add_crossing(line, other, first.relation);
      mark(first.other, pencils_.size() - 1);
      place = place.subspan(1);
    } else if (pencil.here && first.end == kNone) {
      add_touch(line, pencil.end);
    }
    for (const Meeting& m : place) join(pencils_.size() - 1, m);
  }

  /// Adds the other line of a meeting to a pencil.
  void join(std::size_t index, const Meeting& m) {
    mark(m.other, index);
    const Pencil& pencil = pencils_[index];
    const LineId line = members_[m.other].line;
    if (!pencil.here) return;
    if (pencil.end != kNone) {
      // Ends at one point are known to be the same.
      if (m.end_other == kNone) add_touch(line, pencil.end);
    } else if (m.end_other != kNone) {
      add_touch(pencil.s, m.end_other);
    } else {
      const LineId cutter = kernel_.compare_directions(line, pencil.s) != 0 ? pencil.s : pencil.o;
      found_.throughs.push_back({line, pencil.crossing, kernel_.parameter(line, cutter)});
    }
  }
  bool all_in_one_pencil() const {
    std::uint64_t all = ~std::uint64_t{0};
    for (const std::uint64_t common : common_) all &= common;
    return all != 0;
  }
  void add_touch(LineId line, EndId end) {
    found_.touches.push_back({line, end, scene_.along(line, scene_.place(end))});
  }

  const Scene<Kernel>& scene_;
  const Kernel& kernel_;
  Pairs<Kernel> pairs_;
  Box box_;
  double margin_ = 0;  ///< twice the greatest of a line here
  Meetings& found_;
  std::vector<Member> members_;
  std::vector<std::uint64_t>
      common_;                ///< per block of members, the pencils that all of them are in
  std::vector<Meeting> row_;  ///< meetings of the present member with later ones
  std::vector<Pencil> pencils_;
};

}  // namespace plumbline::bucket
