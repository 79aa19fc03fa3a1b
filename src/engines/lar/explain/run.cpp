#include "engines/lar/explain/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/point_d.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

double distance_to_line(const PointD& p, const PointD& a, const PointD& b) {
  return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / distance(a, b);
}

/// Bends of less are rounding.
constexpr double kLeastBend = 0x1p-40;
/// How far from a finding an edge may have been led away, in radii.
constexpr double kReach = 4;

bool changes(const Round& round) { return round.pruning.clusters.size() > 0; }

/// The quotient by equality: what merging vertices does exactly. Requires: ascending vertices.
Pruning equal_vertices(const std::vector<PointD>& vertices) {
  Pruning result;
  for (const PointD& p : vertices) {
    if (result.vertices.empty() || result.vertices.back() != p) result.vertices.push_back(p);
    result.vertex_map.emplace_back(result.vertices.size() - 1);
  }
  return result;
}

}  // namespace

ExplainedRun::ExplainedRun(std::shared_ptr<const Trace> trace, std::size_t threads)
    : owner_(std::move(trace)), trace_(*owner_), threads_(threads) {
  for (std::size_t r = 1; r <= trace_.rounds.size(); ++r) {
    merged_.push_back(merged_in(r));
    bends_.push_back(bends_in(r));
    std::vector<Bend> by_x;
    for (const auto& [segment, bend] : bends_.back()) by_x.push_back(bend);
    std::stable_sort(by_x.begin(), by_x.end(),
                     [](const Bend& a, const Bend& b) { return a.point < b.point; });
    bends_by_x_.push_back(std::move(by_x));
  }
}

PointD ExplainedRun::drawn(const PointD& p) const {
  return {std::ldexp(p.x, trace_.exponent), std::ldexp(p.y, trace_.exponent)};
}

const Graph& ExplainedRun::before(std::size_t round) const {
  return round == 1 ? trace_.drawing : trace_.rounds[round - 2].simplified;
}

LineWork ExplainedRun::line_work(const Graph& graph) const {
  LineWork result;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [tail, head] = graph.edges[e];
    if (tail == head) {
      result.points.push_back(drawn(graph.vertices[tail]));
      continue;
    }
    result.segments.push_back({drawn(graph.vertices[tail]), drawn(graph.vertices[head])});
    result.sources.push_back(graph.edge_sources[e]);
  }
  return result;
}

std::vector<StageOutput> ExplainedRun::outputs() const {
  std::vector<StageOutput> result;
  const auto add = [&](Stage stage, std::size_t round, bool changed, const Graph& graph) {
    result.push_back({to_text(stage), round, changed, changed ? line_work(graph) : LineWork{},
                      stage == Stage::Intersect});
  };
  add(Stage::Transform, 0, true, trace_.drawing);
  for (std::size_t r = 1; r <= trace_.rounds.size(); ++r) {
    const Round& round = trace_.rounds[r - 1];
    add(Stage::Intersect, r, !round.cuts.flat().empty(), round.split);
    add(Stage::Prune, r, changes(round), round.simplified);
  }
  return result;
}

std::string ExplainedRun::late_stage(const Finding& finding) const {
  const bool is_about_nesting =
      finding.kind == CellKind::Hole || finding.disagreement == Disagreement::WrongParent;
  if (!finding.invariant) return to_text(is_about_nesting ? Stage::Nesting : Stage::FaceWalk);
  switch (*finding.invariant) {
    case Invariant::CyclicOrder:
      return to_text(Stage::EdgeOrder);
    case Invariant::Orientation:
    case Invariant::Area:
      return to_text(Stage::OuterFace);
    case Invariant::Nesting:
    case Invariant::Derived:
      return to_text(Stage::Nesting);
    default:
      return to_text(Stage::FaceWalk);
  }
}

engine_steps::MergedVertices ExplainedRun::merged_in(std::size_t round) const {
  const Round& r = trace_.rounds[round - 1];
  std::vector<std::vector<SegmentId>> segments_at(r.split.vertices.size());
  std::vector<bool> is_merged(r.split.vertices.size());
  for (const VertexId v : r.pruning.clusters.flat()) is_merged[v] = true;
  for (std::size_t e = 0; e < r.split.edges.size(); ++e) {
    for (const VertexId v : {r.split.edges[e].tail, r.split.edges[e].head}) {
      if (is_merged[v]) {
        segments_at[v].insert(segments_at[v].end(), r.split.edge_sources[e].begin(),
                              r.split.edge_sources[e].end());
      }
    }
  }
  engine_steps::MergedVertices result;
  for (std::size_t i = 0; i < r.pruning.clusters.size(); ++i) {
    const auto members = r.pruning.clusters[i];
    std::vector<PointD> points;
    std::vector<SegmentId> segments;
    for (const VertexId v : members) {
      points.push_back(drawn(r.split.vertices[v]));
      segments.insert(segments.end(), segments_at[v].begin(), segments_at[v].end());
    }
    const PointD& merged = r.pruning.vertices[r.pruning.vertex_map[members.front()]];
    result.add(engine_steps::cluster(std::move(points), drawn(merged)), segments);
  }
  result.sort();
  return result;
}

std::vector<std::pair<SegmentId, ExplainedRun::Bend>> ExplainedRun::bends_in(
    std::size_t round) const {
  const Graph& graph = before(round);
  const double radius = std::ldexp(trace_.radius, -trace_.exponent);
  std::vector<std::pair<SegmentId, Bend>> result;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const Cut& cut : trace_.rounds[round - 1].cuts[e]) {
      const double away = distance_to_line(cut.point, graph.vertices[graph.edges[e].tail],
                                           graph.vertices[graph.edges[e].head]);
      if (away <= kLeastBend * radius) continue;
      for (const SegmentId s : graph.edge_sources[e]) {
        result.push_back({s, {drawn(cut.point), std::ldexp(away, trace_.exponent)}});
      }
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return result;
}

Cause ExplainedRun::explained(const Finding& finding, Cause cause) const {
  cause.advice = "decide it exactly: plumbline arrange";
  switch (stage_of(cause.stage)) {
    case Stage::Prune:
      explain_merge(finding, cause);
      break;
    case Stage::Intersect:
      explain_meeting(finding, cause);
      break;
    case Stage::EdgeOrder:
      cause.rule = "rounded-slopes";
      cause.explanation = "the order of the edges around a vertex was decided by rounded slopes";
      break;
    case Stage::Nesting:
      cause.rule = "rounded-position";
      cause.explanation = "which face contains a component was decided by rounding";
      break;
    case Stage::OuterFace:
      cause.rule = "rounded-area";
      cause.explanation = "the outer boundary was chosen by rounded coordinates";
      break;
    default:
      cause.rule = "cycles";
      cause.explanation = "the walk along the cycles went wrong";
  }
  return cause;
}

void ExplainedRun::explain_merge(const Finding& finding, Cause& cause) const {
  const engine_steps::Cluster* merged =
      merged_[cause.round - 1].nearest_to(nearest(finding.where), finding.segments);
  if (!merged) {
    cause.rule = "merged-within-radius";
    cause.explanation = fmt::format("vertices within the radius {:.3g} were merged", trace_.radius);
    cause.advice.clear();
    return;
  }
  const double extent = merged->extent;
  // A vertex that is none of the merged ones is where edges cross that did not.
  const bool crosses =
      finding.disagreement == Disagreement::Invalid ||
      (finding.disagreement == Disagreement::Extra && finding.kind == CellKind::Vertex &&
       distance(nearest(finding.where), merged->merged) > kLeastBend * trace_.radius);
  if (crosses) {
    cause.rule = "fold-over";
  } else if (extent > trace_.radius * (1 + 0x1p-30)) {
    cause.rule = "chain-collapse";
  } else {
    cause.rule = "merged-within-radius";
  }
  cause.explanation = fmt::format(
      "merging within the radius {:.3g} made one vertex of {} that are {}{:.3g} apart{}{}",
      trace_.radius, merged->size, merged->size == 2 ? "" : "up to ",
      merged->size == 2 ? merged->least_distance : extent,
      extent > trace_.radius ? ", each near the next" : "",
      crosses ? ", which led edges across others" : "");
  cause.distance = merged->least_distance;
  cause.advice.clear();
}

/// The nearest bend of any edge within some radii; none where there is none.
const ExplainedRun::Bend* ExplainedRun::bend_near(const PointD& p, std::size_t round) const {
  const auto& bends = bends_by_x_[round - 1];
  const double reach = kReach * trace_.radius;
  const Bend* result = nullptr;
  double least = reach;
  for (auto it = std::lower_bound(bends.begin(), bends.end(), p.x - reach,
                                  [](const Bend&b, double x) { return b.point.x < x; });
       it != bends.end() && it->point.x <= p.x + reach; ++it) {
    if (const double away = distance(it->point, p);
        away < least || (away == least && (!result || it->distance < result->distance))) {
      least = away;
      result = &*it;
    }
  }
  return result;
}

void ExplainedRun::explain_meeting(const Finding& finding, Cause& cause) const {
  const PointD where = nearest(finding.where);
  const auto& bends = bends_[cause.round - 1];
  const Bend* nearest_bend = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentId s : finding.segments) {
    for (auto it = std::lower_bound(bends.begin(), bends.end(), s,
                                    [](const auto&a, SegmentId id) { return a.first < id; });
         it != bends.end() && it->first == s; ++it) {
      if (const double away = distance(it->second.point, where);
          away < least || (away == least && it->second.distance < nearest_bend->distance)) {
        least = away;
        nearest_bend = &it->second;
      }
    }
  }
  if (!nearest_bend) nearest_bend = bend_near(where, cause.round);
  if (nearest_bend) {
    cause.rule = "snapped-to-edge";
    cause.explanation =
        fmt::format("within the radius {:.3g}, an edge was led through a vertex {:.3g} beside it",
                    trace_.radius, nearest_bend->distance);
    cause.distance = nearest_bend->distance;
    cause.advice.clear();
    return;
  }
  cause.rule = "missed-meeting";
  cause.explanation = "edges that meet were not cut there, or were cut where they do not meet";
  cause.advice = "decide it exactly: plumbline arrange";
}

Graph ExplainedRun::arranged(const Graph& graph) const {
  LineWork work;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [tail, head] = graph.edges[e];
    if (tail == head) {
      work.points.push_back(graph.vertices[tail]);
      continue;
    }
    work.segments.push_back({graph.vertices[tail], graph.vertices[head]});
    work.sources.push_back(graph.edge_sources[e]);
  }
  const FloatComplex complex = nearest(plumbline::arrange(work, threads_));
  Graph result;
  result.vertices = complex.vertices;
  result.edges = complex.edges;
  result.edge_sources = complex.edge_sources;
  for (const VertexId v : complex.face_isolated_vertices.flat()) {
    result.edges.push_back({v, v});
    result.edge_sources.push_back(std::span<const SegmentId>());
  }
  return simplify(result, equal_vertices(result.vertices));
}

std::optional<FloatComplex> ExplainedRun::with_exact(const std::string& name,
                                                     std::size_t round) const {
  const Stage stage = stage_of(name);
  Graph graph;
  if (stage == Stage::Intersect) {
    const double radius = std::ldexp(trace_.radius, -trace_.exponent);
    graph = arranged(before(round));
    graph = simplify(graph, prune_vertices(graph.vertices, radius));
    for (std::size_t r = round; r < kMaxRounds; ++r) {
      Round next = resolve(graph, radius);
      graph = std::move(next.simplified);
      if (next.cuts.flat().empty() && next.pruning.clusters.size() == 0) break;
    }
  } else if (stage == Stage::Prune) {
    graph = arranged(trace_.rounds[round - 1].split);
  } else {
    graph = arranged(trace_.rounds.back().simplified);
  }
  FloatComplex result = faces(graph);
  for (PointD& p : result.vertices) p = drawn(p);
  return canonical(std::move(result));
}

}  // namespace plumbline::lar
