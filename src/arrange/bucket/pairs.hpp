#pragma once

// What two lines have in common, and where it is recorded.

#include <algorithm>
#include <cmath>
#include <utility>

#include "arrange/bucket/buckets.hpp"

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

/// What the search for meetings looks at. `same_end`: per end the least of the ends at the same
/// point; written for the ends in a bucket by whoever searches that bucket.
template <class Kernel>
struct Scene {
  const Kernel& kernel;
  std::span<const Approx> approx;
  const Buckets& buckets;
  std::vector<EndId>& same_end;

  PointD place(EndId end) const {
    const Approx& l = approx[line_of(end)];
    return is_last(end) ? PointD{l.bx, l.by} : PointD{l.ax, l.ay};
  }
  PointD at(LineId s, double t) const {
    const Approx& l = approx[s];
    return {l.ax + t * (l.bx - l.ax), l.ay + t * (l.by - l.ay)};
  }
  /// The parameter of a point on s.
  double along(LineId s, const PointD& p) const {
    const Approx& l = approx[s];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    return std::abs(dx) >= std::abs(dy) ? (p.x - l.ax) / dx : (p.y - l.ay) / dy;
  }
};

/// Records a crossing, o turning counter-clockwise from s; `turn` is that of the lines as given.
inline void add_crossing(Meetings& found, LineId s, LineId o, double at_s, double at_o, int turn) {
  if (turn > 0) {
    found.crossings.push_back({{s, o}, at_s, at_o});
  } else {
    found.crossings.push_back({{o, s}, at_o, at_s});
  }
}

/// Tests pairs of lines in one bucket.
template <class Kernel>
class Pairs {
 public:
  Pairs(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found)
      : scene_(scene), kernel_(scene.kernel), bucket_(bucket), found_(found) {}

  /// A crossing is computed in the same way in every bucket, so just one of them holds it.
  void test(LineId s, LineId o) {
    if (o < s) std::swap(s, o);
    const Relation r = kernel_.relate(s, o);
    if (r.apart()) return;
    if (r.cross()) {
      const PointD p = scene_.at(s, r.at_s);
      if (is_here(p)) add_crossing(found_, s, o, r.at_s, r.at_o, r.b_to_s);
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

 private:
  bool is_here(const PointD& p) const { return scene_.buckets.bucket_at(p.x, p.y) == bucket_; }

  /// An end on the line through s: a touch if strictly inside s, recorded in the end's bucket.
  void touch(LineId s, EndId end) {
    if (kernel_.compare(first_end(s), end) >= 0 || kernel_.compare(end, last_end(s)) >= 0) return;
    const PointD p = scene_.place(end);
    if (is_here(p)) found_.touches.push_back({s, end, scene_.along(s, p)});
  }

  const Scene<Kernel>& scene_;
  const Kernel& kernel_;
  std::size_t bucket_;
  Meetings& found_;
};

}  // namespace plumbline::bucket
