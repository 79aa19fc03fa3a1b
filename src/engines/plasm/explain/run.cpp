// What attribution asks of a run, and the rules of the catalogue, docs/divergences.md.

#include "engines/plasm/explain/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/lar/explain/cells.hpp"
#include "engines/plasm/explain/replaced_stage.hpp"
#include "engines/plasm/explain/result.hpp"
#include "engines/plasm/explain/stages.hpp"
#include "geometry/point_d.hpp"

namespace plumbline::plasm {
namespace {

constexpr const char* kDecideExactly = "decide it exactly: plumbline arrange";
/// Of the radius: what is nearer is the same place.
constexpr double kSamePlace = 0x1p-30;

void set(Cause& cause, const char* rule, std::string explanation, std::string advice) {
  cause.rule = rule;
  cause.explanation = std::move(explanation);
  cause.advice = std::move(advice);
}

/// Per merged vertex its different places, with the segments there.
struct Members {
  std::vector<PointD> points;
  std::vector<SegmentId> segments;
};
std::vector<Members> members_of(const Trace& trace) {
  std::vector<Members> result(trace.merging.kept.size());
  const Graph& graph = trace.fragments;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const VertexId v : graph.edges[e]) {
      Members& members = result[trace.merging.vertex_map[v]];
      members.points.push_back(graph.vertices[v]);
      members.segments.insert(members.segments.end(), graph.edge_sources[e].begin(),
                              graph.edge_sources[e].end());
    }
  }
  for (Members& members : result) {
    std::sort(members.points.begin(), members.points.end());
    members.points.erase(std::unique(members.points.begin(), members.points.end()),
                         members.points.end());
    std::sort(members.segments.begin(), members.segments.end());
    members.segments.erase(std::unique(members.segments.begin(), members.segments.end()),
                           members.segments.end());
  }
  return result;
}

/// The merged vertices that a vertex is within the radius of, though it went to another one.
std::vector<PointD> contested(const Trace& trace) {
  const std::vector<PointD>& kept = trace.merging.graph.vertices;
  std::vector<std::size_t> by_x(kept.size());
  for (std::size_t v = 0; v < by_x.size(); ++v) by_x[v] = v;
  std::stable_sort(by_x.begin(), by_x.end(),
                   [&](std::size_t v, std::size_t w) { return kept[v] < kept[w]; });
  std::vector<PointD> result;
  for (std::size_t v = 0; v < trace.fragments.vertices.size(); ++v) {
    const PointD& p = trace.fragments.vertices[v];
    const VertexId own = trace.merging.vertex_map[v];
    auto at = std::lower_bound(by_x.begin(), by_x.end(), p.x - trace.radius,
                               [&](std::size_t w, double x) { return kept[w].x < x; });
    for (; at != by_x.end() && kept[*at].x <= p.x + trace.radius; ++at) {
      if (*at != own && distance(kept[*at], p) <= trace.radius) {
        result.insert(result.end(), {kept[*at], kept[own]});
      }
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

ExplainedRun::ExplainedRun(std::shared_ptr<const Trace> trace, std::size_t threads)
    : owner_(std::move(trace)),
      trace_(*owner_),
      threads_(threads),
      odd_cuts_(trace_),
      contested_(contested(trace_)),
      faults_(faults_of(trace_, threads)) {
  std::vector<Members> all = members_of(trace_);
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (all[v].points.size() < 2) continue;
    merged_.add(engine_steps::cluster(std::move(all[v].points), trace_.merging.graph.vertices[v]),
                all[v].segments);
  }
  merged_.sort();
}

std::vector<StageOutput> ExplainedRun::outputs() const {
  std::vector<StageOutput> result;
  const auto add = [&](Stage stage, LineWork work, bool is_cut) {
    result.push_back({to_text(stage), 0, true, std::move(work), stage == Stage::Fragment, is_cut});
  };
  const auto with_points = [&](LineWork work) {
    work.points = trace_.points;
    return work;
  };
  add(Stage::Transform, with_points(line_work(trace_.drawing)), false);
  add(Stage::Fragment, with_points(line_work(trace_.fragments)), true);
  add(Stage::Merge, merged_work(trace_), true);
  add(Stage::ComponentFilter, kept_work(trace_), true);
  return result;
}

ExactComplex ExplainedRun::continued(const StageOutput& output, std::size_t threads) const {
  return output.is_cut ? lar::cells_of(output.work, threads) : arrange(output.work, threads);
}

std::string ExplainedRun::late_stage(const Finding& /*finding*/) const {
  if (trace_.failure || !faults_.is_plane) return to_text(Stage::FaceWalk);
  if (faults_.misorders_edges) return to_text(Stage::EdgeOrder);
  return to_text(faults_.misjudges_areas ? Stage::OuterFace : Stage::Nesting);
}

Cause ExplainedRun::explained(const Finding& finding, Cause cause) const {
  switch (stage_of(cause.stage)) {
    case Stage::Fragment:
      explain_cut(finding, cause);
      break;
    case Stage::Merge:
      explain_merge(finding, cause);
      break;
    case Stage::ComponentFilter:
      explain_filter(finding, cause);
      break;
    case Stage::EdgeOrder:
      set(cause, "rounded-slopes",
          "the order of the edges around a vertex was decided by rounded slopes", kDecideExactly);
      break;
    case Stage::OuterFace:
      set(cause, "rounded-area",
          "rounded determinants of corners as they are, far from the origin, decided which face is "
          "the unbounded one",
          "move the drawing to the origin first");
      break;
    case Stage::Nesting:
      explain_nesting(finding, cause);
      break;
    default:
      set(cause, "crossed-walk",
          "edges cross or overlap, so what grew from an edge by angles is no face", kDecideExactly);
  }
  return cause;
}

void ExplainedRun::explain_cut(const Finding& finding, Cause& cause) const {
  const OddCut* odd = odd_cuts_.nearest_to(nearest(finding.where), finding.segments);
  if (!odd) {
    return set(cause, "split-junction",
               "each edge has its own cut at a junction, and rounding put them further apart than "
               "the radius, or left one out",
               "move the drawing to the origin, or take a radius above its rounding");
  }
  switch (odd->kind) {
    case OddCut::Kind::Parallel:
      return set(cause, "nearly-parallel",
                 fmt::format("edges whose cosine is within {:.3g} of 1 count as parallel, and were "
                             "not cut where they meet",
                             trace_.radius),
                 kDecideExactly);
    case OddCut::Kind::Collinear:
      cause.distance = odd->distance;
      return set(cause, "nearly-collinear",
                 fmt::format("edges that look collinear from one end cut each other at their ends, "
                             "here {:.3g} beside the edge",
                             odd->distance),
                 kDecideExactly);
    case OddCut::Kind::Reach:
      cause.distance = odd->distance;
      return set(cause, "relative-reach",
                 fmt::format("parameters up to {:.3g} beyond the ends count, whatever the lengths: "
                             "here edges meet {:.3g} beyond an end",
                             trace_.radius, odd->distance),
                 "a smaller radius, or shorter edges");
  }
}

void ExplainedRun::explain_merge(const Finding& finding, Cause& cause) const {
  const engine_steps::Cluster* merged =
      merged_.nearest_to(nearest(finding.where), finding.segments);
  if (!merged) {
    return set(cause, "merged-within-radius",
               fmt::format("vertices within the radius {:.3g} were merged", trace_.radius), "");
  }
  cause.distance = merged->least_distance;
  const bool crosses =
      finding.disagreement == Disagreement::Invalid ||
      (finding.disagreement == Disagreement::Extra && finding.kind == CellKind::Vertex &&
       distance(nearest(finding.where), merged->merged) > kSamePlace * trace_.radius);
  if (crosses) {
    return set(cause, "fold-over",
               fmt::format("merging within the radius {:.3g} led edges across others, which are "
                           "not cut again",
                           trace_.radius),
               "");
  }
  if (std::binary_search(contested_.begin(), contested_.end(), merged->merged)) {
    return set(cause, "first-come",
               fmt::format("a vertex within the radius {:.3g} of two others that stay apart went "
                           "to the later one",
                           trace_.radius),
               "");
  }
  set(cause, "merged-within-radius",
      fmt::format("vertices within the radius {:.3g} became the first of them", trace_.radius), "");
}

void ExplainedRun::explain_filter(const Finding& finding, Cause& cause) const {
  const PointD where = nearest(finding.where);
  const bool is_point =
      finding.kind == CellKind::Vertex &&
      std::find(trace_.points.begin(), trace_.points.end(), where) != trace_.points.end();
  if (is_point) {
    return set(cause, "points-dropped", "isolated points bound no edge, and are left out",
               kDecideExactly);
  }
  set(cause, "bridges-dropped",
      "edges in no cycle are left out: dangling ones, and bridges between cycles", kDecideExactly);
}

void ExplainedRun::explain_nesting(const Finding& finding, Cause& cause) const {
  const PointD where = nearest(finding.where);
  const auto nearer = [&](const Misplaced& a, const Misplaced& b) {
    return distance(a.where, where) < distance(b.where, where);
  };
  const auto found = std::min_element(faults_.misplaced.begin(), faults_.misplaced.end(), nearer);
  if (found == faults_.misplaced.end()) {
    return set(cause, "rounded-position", "which face contains a component was decided by rounding",
               kDecideExactly);
  }
  if (found->kind == Misplaced::Kind::FirstBox) {
    return set(cause, "first-box",
               "a component became the hole of the first face whose box has its box, not of the "
               "face around it",
               kDecideExactly);
  }
  set(cause, "vertex-on-shell",
      "a component is in another one if its first vertex is, and that lies on the other's outline",
      kDecideExactly);
}

std::optional<FloatComplex> ExplainedRun::with_exact(const std::string& stage,
                                                     std::size_t /*round*/) const {
  return run_with_exact(trace_, stage_of(stage), threads_);
}

std::optional<std::string> ExplainedRun::suspect(const Cause& cause) const {
  if (cause.rule != "bridges-dropped") return std::nullopt;
  return to_text(Stage::Fragment);
}

std::vector<Explained> failures(const Trace& trace) {
  if (!trace.failure) return {};
  Explained result;
  result.finding.kind = CellKind::Complex;
  result.finding.disagreement = Disagreement::Missing;
  result.finding.message = "Plasm.jl has no result: " + trace.failure->message;
  result.cause.confirmed = true;  // the exact counterpart always has a result
  switch (trace.failure->kind) {
    case Failure::Kind::NoCycle:
      result.cause.stage = to_text(Stage::ComponentFilter);
      set(result.cause, "no-cycle", "where there is no cycle, nothing is returned",
          "return the vertices and edges, and the unbounded face");
      break;
    case Failure::Kind::EndlessWalk:
      result.cause.stage = to_text(Stage::FaceWalk);
      set(result.cause, "endless-walk",
          "edges cross or overlap, and what grew from an edge by angles does not close",
          kDecideExactly);
      break;
    case Failure::Kind::NoShell:
      result.cause.stage = to_text(Stage::OuterFace);
      set(result.cause, "no-shell",
          "no face has all outermost vertices and a negative area, since edges cross or rounding "
          "took the sign",
          "move the drawing to the origin first");
  }
  return {result};
}

}  // namespace plumbline::plasm
