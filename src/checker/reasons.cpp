// Step 1: every vertex is an end of a segment, a point of the input or the only common point of two
// segments, and is there for the first of these reasons that applies.

#include <algorithm>
#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_checker {
namespace {

/// What a step finds of each vertex; kNone if nothing.
class Reasons {
 public:
  Reasons(const Input& input, const Certificate& certificate)
      : input_(input),
        certificate_(certificate),
        ending_(certificate.vertices.size(), kNone),
        least_(ending_),
        other_(ending_),
        point_(ending_) {
    find_ends();
    find_crossings();
    find_points();
  }

  /// The reason as certificates have it, "" if there is none.
  std::string of(Index v) const {
    if (ending_[v] != kNone) {
      const Segment& segment = input_.segments[ending_[v]];
      const bool is_last = certificate_.vertices[v] == segment.last;
      return "end " + std::to_string(ending_[v]) + (is_last != segment.reversed ? " 1" : " 0");
    }
    if (other_[v] != kNone) {
      return "cross " + std::to_string(least_[v]) + " " + std::to_string(other_[v]);
    }
    return point_[v] != kNone ? "point " + std::to_string(point_[v]) : "";
  }

 private:
  void find_ends() {
    for (Index e = 0; e < certificate_.edges.size(); ++e) {
      const auto [tail, head] = certificate_.edges[e];
      const Lists& segments = certificate_.segments;
      for (const Index* s = segments.begin(e); s != segments.end(e); ++s) {
        const Segment& segment = input_.segments[*s];
        if (*s < ending_[tail] && certificate_.vertices[tail] == segment.first) ending_[tail] = *s;
        if (*s < ending_[head] && certificate_.vertices[head] == segment.last) ending_[head] = *s;
      }
    }
  }

  /// The segments through a vertex are those of its edges, and those of one edge are parallel: so
  /// the least of each edge decides.
  void find_crossings() {
    for_each_edge_at_vertex([&](Index v, Index s) { least_[v] = std::min(least_[v], s); });
    for_each_edge_at_vertex([&](Index v, Index s) {
      const bool is_less = ending_[v] == kNone && s < other_[v];
      if (is_less && turn(input_.segments[s].line, input_.segments[least_[v]].line) != 0) {
        other_[v] = s;
      }
    });
  }
  template <class Visit>
  void for_each_edge_at_vertex(const Visit& visit) const {
    for (Index e = 0; e < certificate_.edges.size(); ++e) {
      visit(certificate_.edges[e].tail, *certificate_.segments.begin(e));
      visit(certificate_.edges[e].head, *certificate_.segments.begin(e));
    }
  }

  void find_points() {
    const std::vector<Point>& vertices = certificate_.vertices;
    for (Index p = 0; p < input_.points.size(); ++p) {
      const Point& point = input_.points[p];
      const auto found = std::lower_bound(vertices.begin(), vertices.end(), point, before);
      if (found == vertices.end() || !(*found == point)) {
        throw Refusal{"no vertex is at point " + std::to_string(p) + " of the input",
                      certificate_.vertex_line, text_of(point)};
      }
      Index& least = point_[static_cast<std::size_t>(found - vertices.begin())];
      least = std::min(least, p);
    }
  }

  const Input& input_;
  const Certificate& certificate_;
  std::vector<Index> ending_;  ///< the least segment that ends there
  std::vector<Index> least_,
      other_;                 ///< the least segment, and the least that is not parallel to it
  std::vector<Index> point_;  ///< the least point of the input
};

}  // namespace

void check_reasons(const Input& input, const Certificate& certificate) {
  const Reasons reasons(input, certificate);
  for (Index v = 0; v < certificate.vertices.size(); ++v) {
    const std::string reason = reasons.of(v);
    if (reason.empty()) {
      certificate.refuse_vertex(
          v,
          "has no reason: no segment ends there, no two that are not parallel "
          "meet there, no point of the input is there");
    }
    require("the reason of vertex " + std::to_string(v), certificate.reasons[v], reason,
            certificate.vertex_line + v, &certificate.vertices[v]);
  }
}

}  // namespace plumbline_checker
