// What each dangling end is: the nearest explanation wins. Where two ends are near, and one of them
// heads for the other one's edge, that one is short of it, and the other one too long; else there
// is a gap between them.

#include <algorithm>
#include <limits>
#include <optional>

#include "diagnose/steps.hpp"
#include "geometry/point_d.hpp"

namespace plumbline::diagnose_steps {
namespace {

// Of 60 degrees, up to which a place is ahead, and of 30, up to which lines are side by side.
constexpr double kCosineAhead = 0.5, kCosineAside = 0.8660254037844387;
// More than rounding does to a cosine, if vectors are longer by the inverse than what rounding does
// to them.
constexpr double kAngleMargin = 1e-3;

struct Vector {
  Rational x, y;
};
Vector from_to(const Point& p, const Point& q) { return {q.x - p.x, q.y - p.y}; }
PointD from_to(const PointD& p, const PointD& q) { return {q.x - p.x, q.y - p.y}; }
Rational dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }

/// The direction in which the line ends at a tip.
Vector direction(const LineGraph& graph, VertexId tip) {
  const auto& vertices = graph.complex().vertices;
  return from_to(vertices[graph.other_end(graph.edges(tip)[0], tip)], vertices[tip]);
}

/// Of u x v.
Rational cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

/// Whether the angle is at most 60 degrees: its cosine at least 1/2.
bool is_ahead(const Vector& direction, const Vector& to) {
  const Rational along = dot(direction, to);
  return sgn(along) > 0 && 4 * along * along >= dot(direction, direction) * dot(to, to);
}

/// Whether the angle is less than 30 degrees: its squared cosine more than 3/4.
bool is_side_by_side(const Vector& u, const Vector& v) {
  const Rational along = dot(u, v);
  return sgn(along) > 0 && 4 * along * along > 3 * dot(u, u) * dot(v, v);
}

/// Whether the angle of two lines is less than 30 degrees.
bool is_shallow(const Vector& u, const Vector& v) {
  return 4 * cross(u, v) * cross(u, v) < dot(u, u) * dot(v, v);
}

class Classifier {
 public:
  explicit Classifier(const Subject& subject)
      : subject_(subject),
        graph_(subject.graph),
        reach_(nearest_double(subject.within) * (1 + kAngleMargin) + graph_.slack()) {}

  /// The tip, and whether the search for what is near it was cut short in vain.
  std::pair<Tip, bool> classify(VertexId v) const {
    const Chain line = graph_.chain(v, graph_.edges(v)[0]);
    const NearEdges::Answer near = subject_.near.near(v);
    Tip tip;
    tip.vertex = v;
    find_nearest(tip, line, near);
    const bool is_found = tip.kind != DefectKind::Dangle;
    if (is_overshoot(line) && (!is_found || is_shorter(line, tip.squared_distance))) {
      tip = {v, DefectKind::Overshoot, {}, {}, {}, {}};
    }
    if (tip.kind == DefectKind::Gap) find_meeting(tip, near);
    return {tip, near.cut_short && tip.kind == DefectKind::Dangle};
  }

 private:
  void find_nearest(Tip& tip, const Chain& line, const NearEdges::Answer& near) const {
    const ExactComplex& complex = graph_.complex();
    const Vector end = direction(graph_, tip.vertex);
    for (const NearEdge& candidate : near.edges) {
      if (is_clearly_aside(tip.vertex, candidate)) continue;
      const bool is_found = tip.kind != DefectKind::Dangle;
      if (is_found &&
          candidate.distance > nearest_sqrt(tip.squared_distance) + 2 * graph_.slack()) {
        break;
      }
      Nearest found = nearest_on_edge(complex, tip.vertex, candidate.edge);
      const VertexId partner = end_to_join(line, end, found, candidate.edge);
      DefectKind kind = partner.valid() ? DefectKind::Gap : DefectKind::Undershoot;
      if (partner.valid()) {
        const Point &p = complex.vertices[tip.vertex], &q = complex.vertices[partner];
        const EdgeId own = graph_.edges(tip.vertex)[0];
        if (hit(tip.vertex, candidate.edge)) {
          kind = DefectKind::Undershoot;
        } else if (const std::optional<Point> x = hit(partner, own)) {
          kind = DefectKind::Overshoot;
          found.squared_distance = squared_distance(p, *x);
        } else {
          found.squared_distance = squared_distance(p, q);
        }
      }
      if (found.squared_distance > subject_.squared_within) continue;
      if (is_found && found.squared_distance >= tip.squared_distance) continue;
      const Vector ahead = from_to(complex.vertices[tip.vertex], found.foot);
      if (!partner.valid() && (is_tip(found.end) || !is_ahead(end, ahead))) continue;
      tip.kind = kind;
      tip.partner = kind == DefectKind::Undershoot ? VertexId() : partner;
      tip.edge = candidate.edge;
      tip.squared_distance = std::move(found.squared_distance);
    }
  }

  /// Where the line that ends at the tip would meet the inside of the edge, near the tip and at an
  /// angle of 30 degrees or more.
  std::optional<Point> hit(VertexId tip, EdgeId e) const {
    const auto& vertices = graph_.complex().vertices;
    const Edge& edge = graph_.complex().edges[e];
    const Point p = vertices[tip], a = vertices[edge.tail], b = vertices[edge.head];
    const Vector u = direction(graph_, tip), w = from_to(a, b);
    if (is_shallow(u, w)) return std::nullopt;
    const Vector off = from_to(p, a);
    const Rational turn = cross(u, w), along = cross(off, w) / turn, part = cross(off, u) / turn;
    if (sgn(along) <= 0 || sgn(part) <= 0 || part >= 1) return std::nullopt;
    if (along * along * dot(u, u) > subject_.squared_within) return std::nullopt;
    return Point{p.x + along * u.x, p.y + along * u.y};
  }

  /// The tips no further than twice the gap whose lines would meet the tip's own line ahead of
  /// both.
  void find_meeting(Tip& tip, const NearEdges::Answer& near) const {
    const ExactComplex& complex = graph_.complex();
    const double reach = 2 * nearest_sqrt(tip.squared_distance) + 2 * graph_.slack();
    for (const NearEdge& candidate : near.edges) {
      if (candidate.distance > reach * (1 + kAngleMargin)) break;
      for (const VertexId v :
           {complex.edges[candidate.edge].tail, complex.edges[candidate.edge].head}) {
        if (!graph_.is_tip(v) || !lead_to_one_point(tip.vertex, v)) continue;
        if (squared_distance(complex.vertices[tip.vertex], complex.vertices[v]) <=
            4 * tip.squared_distance) {
          tip.meets.push_back(v);
        }
      }
    }
    std::sort(tip.meets.begin(), tip.meets.end());
  }

  /// Whether the lines that end at the two tips would meet, within the distance of both.
  bool lead_to_one_point(VertexId v, VertexId w) const {
    const auto& vertices = graph_.complex().vertices;
    const Vector a = direction(graph_, v), b = direction(graph_, w);
    const Vector off = from_to(vertices[v], vertices[w]);
    const Rational turn = cross(a, b);
    if (sgn(turn) == 0) {
      return sgn(cross(off, a)) == 0 && sgn(dot(off, a)) > 0 && sgn(dot(a, b)) < 0;
    }
    const auto is_ahead_near = [&](const Rational& along, const Vector& u) {
      return sgn(along) >= 0 && along * along * dot(u, u) <= subject_.squared_within;
    };
    return is_ahead_near(cross(off, b) / turn, a) && is_ahead_near(cross(off, a) / turn, b);
  }

  /// Whether it is out of question that the candidate is ahead of the tip, or ends in a tip to
  /// join; only then true.
  bool is_clearly_aside(VertexId tip, const NearEdge& candidate) const {
    const Edge& edge = graph_.complex().edges[candidate.edge];
    const PointD &p = graph_.rounded(tip), &q = candidate.foot;
    const auto cannot_join = [&](VertexId v) {
      return !graph_.is_tip(v) || quick_length(from_to(p, graph_.rounded(v))) > reach_ ||
             cosine(tip, rounded_direction(v)) > kCosineAside + kAngleMargin;
    };
    return cosine(tip, from_to(p, q)) < kCosineAhead - kAngleMargin && cannot_join(edge.tail) &&
           cannot_join(edge.head);
  }

  /// Of the angle between the direction in which a line ends at a tip and another vector;
  /// **rounded**. Not a number where one of them is so short that rounding may turn it.
  double cosine(VertexId tip, const PointD& v) const {
    const PointD u = rounded_direction(tip);
    const double length = quick_length(u), other_length = quick_length(v);
    if (std::min(length, other_length) * kAngleMargin < 4 * graph_.slack()) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return (u.x / length) * (v.x / other_length) + (u.y / length) * (v.y / other_length);
  }

  PointD rounded_direction(VertexId tip) const {
    return from_to(graph_.rounded(graph_.other_end(graph_.edges(tip)[0], tip)),
                   graph_.rounded(tip));
  }

  bool is_tip(VertexId v) const { return v.valid() && graph_.is_tip(v); }

  /// The other tip where the edge dangles as well and ends near enough; none else.
  VertexId end_to_join(const Chain& line, const Vector& end, const Nearest& found,
                       EdgeId candidate) const {
    if (found.squared_distance > subject_.squared_within) return {};
    const ExactComplex& complex = graph_.complex();
    const Point& p = complex.vertices[line.first];
    VertexId best;
    for (const VertexId v : {complex.edges[candidate].tail, complex.edges[candidate].head}) {
      if (!graph_.is_tip(v) || !can_join(line, end, v)) continue;
      if (squared_distance(p, complex.vertices[v]) > subject_.squared_within) continue;
      if (best.valid() &&
          squared_distance(p, complex.vertices[v]) >= squared_distance(p, complex.vertices[best])) {
        continue;
      }
      best = v;
    }
    return best;
  }

  bool can_join(const Chain& line, const Vector& end, VertexId other) const {
    if (is_side_by_side(end, direction(graph_, other))) return false;
    // The ends of a line that is itself as small are no gap.
    return line.last != other || !graph_.is_within(line, subject_.within);
  }

  bool is_overshoot(const Chain& line) const {
    return goes_beyond(subject_, line) && graph_.is_within(line, subject_.within);
  }

  /// Whether the line is shorter than the root of `squared`: multiply both by that root.
  bool is_shorter(const Chain& line, const Rational& squared) const {
    Roots scaled;
    for (const EdgeId e : line.edges) scaled.add(graph_.squared_length(e) * squared);
    return scaled.compare(squared) < 0;
  }

  const Subject& subject_;
  const LineGraph& graph_;
  const double reach_;  ///< clearly more than the search distance
};

}  // namespace

bool goes_beyond(const Subject& subject, const Chain& line) {
  if (subject.graph.degree(line.last) < 3) return false;
  const Point& junction = subject.graph.complex().vertices[line.last];
  const auto sources = subject.graph.complex().edge_sources[line.edges.back()];
  return std::any_of(sources.begin(), sources.end(), [&](SegmentId s) {
    const Segment segment = subject.input.segments[s];
    return segment.a != junction && segment.b != junction;
  });
}

const Tip& Tips::at(VertexId v) const {
  return *std::partition_point(tips.begin(), tips.end(),
                               [&](const Tip& tip) { return tip.vertex < v; });
}

Tips classify_tips(const Subject& subject) {
  Tips result;
  const Classifier classifier(subject);
  for (std::size_t v = 0; v < subject.graph.complex().vertices.size(); ++v) {
    if (!subject.graph.is_tip(VertexId(v))) continue;
    auto [tip, cut_short] = classifier.classify(VertexId(v));
    result.tips.push_back(std::move(tip));
    result.cut_short += cut_short ? 1 : 0;
  }
  return result;
}

}  // namespace plumbline::diagnose_steps
