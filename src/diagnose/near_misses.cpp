// Vertices near edges and vertices that they do not touch, unless the drawing itself explains it: a
// tip that has a name of its own, or a short way along the edges.

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <set>

#include "diagnose/steps.hpp"
#include "diagnose/ways.hpp"

namespace plumbline::diagnose_steps {
namespace {

// A way along the edges of at most so many times the distance explains why two places are near: two
// sides of a corner of 30 degrees or more, a finely drawn curve, a small shape.
constexpr double kExplainingWay = 4;
// A distance in doubles is good enough to be compared with a way if it is this much larger than
// what rounding does to it.
constexpr double kBelievable = 1000;

class NearMisses {
 public:
  NearMisses(const Subject& subject, const Tips& tips)
      : subject_(subject), graph_(subject.graph), tips_(tips), result_(subject.most_listed) {}

  Defects find() && {
    for (std::size_t v = 0; v < graph_.complex().vertices.size(); ++v) look_around(VertexId(v));
    find_isolated();
    return std::move(result_);
  }

 private:
  void look_around(VertexId v) {
    if (is_explained_tip(v)) return;
    const NearEdges::Answer near = subject_.near.near(v);
    Ways ways(graph_, v);
    std::optional<NearEdge> best;
    Nearest nearest;
    for (const NearEdge& candidate : near.edges) {
      if (best && candidate.distance > best->distance + 2 * graph_.slack()) break;
      if (is_adjacent(v, candidate.edge) || is_explained(ways, candidate, v)) continue;
      Nearest found = nearest_on_edge(graph_.complex(), v, candidate.edge);
      if (found.squared_distance > subject_.squared_within) continue;
      if (best && found.squared_distance >= nearest.squared_distance) continue;
      if (found.end.valid() && is_explained_tip(found.end)) continue;
      best = candidate;
      nearest = std::move(found);
    }
    if (best) {
      add(v, best->edge, nearest);
    } else if (near.cut_short || ways.is_thicket()) {
      result_.add_cut_short();
    }
  }

  bool is_explained_tip(VertexId v) const {
    return graph_.is_tip(v) && tips_.at(v).kind != DefectKind::Dangle;
  }

  /// Whether an edge joins v with an end of e and makes a corner there. It makes none where it
  /// runs beside e: then it is v that should be on e.
  bool is_adjacent(VertexId v, EdgeId e) const {
    const Edge& edge = graph_.complex().edges[e];
    const auto joins = [&](EdgeId f) {
      const VertexId w = graph_.other_end(f, v);
      return (w == edge.tail || w == edge.head) && !nearly_parallel(graph_, w, e, f);
    };
    const auto edges = graph_.edges(v);
    return std::any_of(edges.begin(), edges.end(), joins);
  }

  bool is_explained(Ways& ways, const NearEdge& candidate, VertexId v) const {
    double distance = candidate.distance;
    if (distance < kBelievable * graph_.slack()) {
      distance =
          nearest_sqrt(nearest_on_edge(graph_.complex(), v, candidate.edge).squared_distance);
    }
    return ways.lead_to(candidate.edge, candidate.foot, kExplainingWay * distance);
  }

  void add(VertexId v, EdgeId e, const Nearest& nearest) {
    Defect defect;
    defect.kind = DefectKind::NearMiss;
    defect.where = graph_.complex().vertices[v];
    defect.vertices = {v};
    if (nearest.end.valid()) {
      if (!pairs_.insert(std::minmax({v, nearest.end})).second) return;
      defect.vertices.push_back(nearest.end);
      std::sort(defect.vertices.begin(), defect.vertices.end());
      defect.where = midpoint(defect.where, graph_.complex().vertices[nearest.end]);
      defect.segments = segments_at(defect.vertices);
    } else {
      defect.edges = {e};
      defect.segments = segments_at({v}, {e});
    }
    add_distance(std::move(defect), nearest.squared_distance);
  }

  void add_distance(Defect defect, const Rational& squared) {
    defect.squared_size = squared;
    defect.size = nearest_sqrt(squared);
    defect.proposed_tolerance = root_rounded_up(squared);
    result_.add(std::move(defect));
  }

  std::vector<SegmentId> segments_at(const std::vector<VertexId>& vertices,
                                     std::vector<EdgeId> edges = {}) const {
    for (const VertexId v : vertices) {
      const auto at = graph_.edges(v);
      edges.insert(edges.end(), at.begin(), at.end());
    }
    return graph_.segments(edges);
  }

  /// Pairs of isolated vertices, which are on no edge: by a sweep over x.
  void find_isolated() {
    std::vector<VertexId> isolated;
    const ExactComplex& complex = graph_.complex();
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
      if (graph_.degree(VertexId(v)) == 0) isolated.emplace_back(v);
    }
    for (std::size_t i = 0; i < isolated.size(); ++i) {
      const Point& p = complex.vertices[isolated[i]];
      for (std::size_t j = i + 1; j < isolated.size() && j <= i + NearEdges::kMostEdges; ++j) {
        const Point& q = complex.vertices[isolated[j]];
        if (q.x - p.x > subject_.within) break;
        Rational squared = squared_distance(p, q);
        if (squared > subject_.squared_within) continue;
        Defect defect;
        defect.kind = DefectKind::NearMiss;
        defect.where = midpoint(p, q);
        defect.vertices = {isolated[i], isolated[j]};
        add_distance(std::move(defect), squared);
      }
    }
  }

  const Subject& subject_;
  const LineGraph& graph_;
  const Tips& tips_;
  Defects result_;
  std::set<std::pair<VertexId, VertexId>> pairs_;
};

}  // namespace

Defects near_misses(const Subject& subject, const Tips& tips) {
  return NearMisses(subject, tips).find();
}

}  // namespace plumbline::diagnose_steps
