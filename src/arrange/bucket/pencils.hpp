#pragma once

// Full buckets: many lines that all but share a direction, or a point.

#include <algorithm>
#include <cmath>
#include <optional>

#include "arrange/bucket/pairs.hpp"

namespace plumbline::bucket {

template <class Kernel>
class Pencils {
 public:
  Pencils(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found)
      : scene_(scene),
        kernel_(scene.kernel),
        box_(scene.buckets.box(bucket)),
        margin_(2 * scene.buckets.margin()),
        found_(found) {}

  void search(std::span<const LineId> lines, Pairs<Kernel>& pairs) {
    sort_across(lines);
    find_pencils();
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (std::size_t j = i + 1; j < members_.size() && members_[j].low <= members_[i].high; ++j) {
        // Lines of a pencil have no other common point.
        if ((members_[i].pencils & members_[j].pencils) != 0) continue;
        pairs.test(members_[i].line, members_[j].line);
      }
    }
  }

 private:
  static constexpr std::size_t kPencil = 16;  ///< fewer lines through a point go pair by pair
  static constexpr std::size_t kMostPencils = 32;
  static constexpr std::size_t kSamples = 8;

  /// Where a line lies across the common direction, and which pencils it is in.
  struct Member {
    double low, high;
    LineId line;
    std::uint32_t pencils;
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

  /// Looks at the crossings of a few pairs for one that many other lines go through.
  void find_pencils() {
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < kSamples && next < kMostPencils; ++k) {
      // Any fixed choice of pairs serves: the pairs of a pencil are most pairs, or it does not
      // matter.
      const std::size_t n = members_.size();
      const Member& first = members_[(2 * k + 1) * n / (2 * kSamples + 2)];
      const Member& second = members_[(2 * k + 3) * n / (2 * kSamples + 2)];
      if (first.line == second.line || (first.pencils & second.pencils) != 0) continue;
      const Relation r = kernel_.relate(first.line, second.line);
      if (r.cross() && add_pencil(first.line, second.line, r, 1U << next)) ++next;
    }
  }

  bool add_pencil(LineId s, LineId o, const Relation& r, std::uint32_t bit) {
    const PointD p = scene_.at(s, r.at_s);
    std::vector<Member*> pencil;
    for (Member& m : members_) {
      if (goes_through(m.line, s, o, p)) pencil.push_back(&m);
    }
    if (pencil.size() < kPencil || 8 * pencil.size() < members_.size()) return false;
    for (Member* m : pencil) m->pencils |= bit;
    if (box_.x0 - margin_ <= p.x && p.x <= box_.x1 + margin_ && box_.y0 - margin_ <= p.y &&
        p.y <= box_.y1 + margin_) {
      record(pencil, s, o, r);
    }
    return true;
  }

  /// Whether a line has the crossing of s and o, which is near p, in its interior or at an end.
  bool goes_through(LineId line, LineId s, LineId o, const PointD& p) const {
    if (line == s || line == o) return true;
    if (kernel_.is_point(line)) return false;
    const Approx& l = scene_.approx[line];
    const auto [bottom, top] = std::minmax(l.ay, l.by);
    if (p.x < l.ax - margin_ || p.x > l.bx + margin_ || p.y < bottom - margin_ ||
        p.y > top + margin_) {
      return false;
    }
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double across = dx * (p.y - l.ay) - dy * (p.x - l.ax);
    if (std::abs(across) > 2 * margin_ * (std::abs(dx) + std::abs(dy))) return false;
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

  /// One meeting for the pencil: an end there, or else the crossing of s and o.
  void record(const std::vector<Member*>& pencil, LineId s, LineId o, const Relation& r) {
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
    if (!end) add_crossing(found_, s, o, r.at_s, r.at_o, r.b_to_s);
    for (const LineId line : inside) {
      if (end) {
        found_.touches.push_back({line, *end, scene_.along(line, scene_.place(*end))});
      } else if (line != s && line != o) {
        found_.throughs.push_back(
            {line, crossing, kernel_.parameter(line, cutter(line, s, o))});
      }
    }
  }

  const Scene<Kernel>& scene_;
  const Kernel& kernel_;
  Box box_;
  double margin_;
  Meetings& found_;
  std::vector<Member> members_;
};

}  // namespace plumbline::bucket
