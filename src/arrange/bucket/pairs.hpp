#pragma once

// What two lines have in common, and where it is recorded.

#include <algorithm>
#include <cmath>
#include <utility>

#include "arrange/bucket/membership.hpp"

namespace plumbline::bucket {

/// An end in the interior of a line.
struct Touch {
  LineId line;
  EndId end;
  double at;
};

/// A line that goes through a crossing of two others.
struct Through {
  LineId line;
  std::uint32_t crossing;  ///< index into the same Meetings::crossings
  double at;
};

/// A crossing and its parameters along both lines.
struct CrossingAt {
  Crossing lines;
  double at_s, at_o;
};

/// What was found in a range of buckets.
struct Meetings {
  std::vector<CrossingAt> crossings;
  std::vector<Touch> touches;
  std::vector<Through> throughs;
};

/// What the search for meetings looks at.
template <class Kernel>
struct Scene {
  const Kernel& kernel;
  std::span<const Approx> approx;
  const Buckets& buckets;

  PointD place(EndId end) const {
    const Approx& l = approx[line_of(end)];
    return is_last(end) ? PointD{l.bx, l.by} : PointD{l.ax, l.ay};
  }
  PointD at(LineId s, double t) const {
    const Approx& l = approx[s];
    return {l.ax + t * (l.bx - l.ax), l.ay + t * (l.by - l.ay)};
  }
  double margin(LineId s) const { return buckets.margin()(approx[s]); }
  /// Two parameters along s that are further apart are in the order of their points. Those of
  /// crossings are off by kParameterError each; one of an end, a quotient of differences of rounded
  /// coordinates, by 8 u times the greatest coordinate of s, divided by its length. Of a line that
  /// is all but 0 long they tell nothing.
  double parameter_error(LineId s) const {
    const Approx& l = approx[s];
    const double length = std::max(l.bx - l.ax, std::abs(l.by - l.ay));
    if (!(length > Margin::kLeast)) return INFINITY;
    const double reach = std::max({std::abs(l.ax), std::abs(l.ay), std::abs(l.bx), std::abs(l.by)});
    return 4 * (Kernel::kParameterError + 2 * 0x1p-53) + 20 * 0x1p-53 * (reach / length);
  }
  /// The parameter of a point on s.
  double along(LineId s, const PointD& p) const {
    const Approx& l = approx[s];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    return std::abs(dx) >= std::abs(dy) ? (p.x - l.ax) / dx : (p.y - l.ay) / dy;
  }
};

/// Where a line meets another: at an end of one of them, or else crossing the line `cutter`.
struct Place {
  EndId end;  ///< kNone for a crossing
  LineId cutter;
};

/// Order of two places along s. **Exact**.
template <class Kernel>
int compare_places(const Kernel& kernel, LineId s, const Place& p, const Place& q) {
  if (p.end != kNone && q.end != kNone) return kernel.compare(p.end, q.end);
  // An end on s comes before a crossing if it lies on the side of the cutting line where s begins.
  const auto compare_end = [&](EndId end, LineId cutter) {
    const int side = kernel.side(cutter, end);
    return side == 0 ? 0 : (side == kernel.side(cutter, first_end(s)) ? -1 : 1);
  };
  if (p.end != kNone) return compare_end(p.end, q.cutter);
  if (q.end != kNone) return -compare_end(q.end, p.cutter);
  return kernel.compare_along(s, p.cutter, q.cutter);
}

/// Tests pairs of lines in one bucket.
template <class Kernel>
class Pairs {
 public:
  Pairs(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found)
      : scene_(scene), kernel_(scene.kernel), here_(scene.buckets, bucket), found_(found) {}

  void test(LineId s, LineId o) {
    if (kernel_.share_end(s, o)) return;  // then nothing else
    if (o < s) std::swap(s, o);
    const Relation r = kernel_.relate(s, o);
    if (!r.apart()) record(s, o, r);
  }

  /// Records what two lines have in common, if it is in this bucket. A crossing is computed in the
  /// same way in every bucket, so just one of them holds it: on the line of lesser margin, so that
  /// the bucket of the computed point lists both. `r`: of the lesser line to the greater.
  void record(LineId s, LineId o, const Relation& r) {
    if (o < s) std::swap(s, o);
    if (r.cross()) {
      const bool on_s = scene_.margin(s) <= scene_.margin(o);
      if (here_.contains(on_s ? scene_.at(s, r.at_s) : scene_.at(o, r.at_o))) add_crossing(s, o, r);
      return;
    }
    const bool s_is_point = kernel_.is_point(s), o_is_point = kernel_.is_point(o);
    if (!s_is_point) {
      // Lines on one supporting line share at most an end.
      if (!o_is_point && r.a_to_s == 0 && r.b_to_s == 0) return;
      if (r.a_to_s == 0) touch(s, first_end(o));
      if (r.b_to_s == 0 && !o_is_point) touch(s, last_end(o));
    }
    if (!o_is_point) {
      if (r.a_to_o == 0) touch(o, first_end(s));
      if (r.b_to_o == 0 && !s_is_point) touch(o, last_end(s));
    }
  }

  /// Records a crossing, the second line turning counter-clockwise from the first.
  void add_crossing(LineId s, LineId o, const Relation& r) {
    if (o < s) std::swap(s, o);
    if (r.b_to_s > 0) {
      found_.crossings.push_back({{s, o}, r.at_s, r.at_o});
    } else {
      found_.crossings.push_back({{o, s}, r.at_o, r.at_s});
    }
  }

 private:
  /// An end on the line through s: a touch if strictly inside s, recorded in the end's bucket.
  void touch(LineId s, EndId end) {
    if (kernel_.compare(first_end(s), end) >= 0 || kernel_.compare(end, last_end(s)) >= 0) return;
    const PointD p = scene_.place(end);
    if (here_.contains(p)) found_.touches.push_back({s, end, scene_.along(s, p)});
  }

  const Scene<Kernel>& scene_;
  const Kernel& kernel_;
  Membership here_;
  Meetings& found_;
};

}  // namespace plumbline::bucket
