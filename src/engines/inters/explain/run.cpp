// What attribution asks of a run of the published pipeline; the rules are in published_rules.cpp.

#include "engines/inters/explain/run.hpp"

#include <algorithm>

#include "compare/wrong_cells.hpp"
#include "engines/inters/explain/replaced_stage.hpp"

namespace plumbline::checking {
namespace {

using lar::published::Trace;

/// The clusters of the run, with the segments at their members.
MergedVertices merged_in(const Trace& trace, const EdgeSources& raw_sources) {
  std::vector<std::vector<SegmentId>> segments_at(trace.raw.vertices.size());
  std::vector<bool> is_merged(trace.raw.vertices.size());
  for (const VertexId v : trace.prune.clusters.flat()) is_merged[v] = true;
  for (const auto& [edge, sources] : raw_sources)
    for (const VertexId v : edge)
      if (is_merged[v]) segments_at[v].insert(segments_at[v].end(), sources.begin(), sources.end());
  MergedVertices result;
  for (std::size_t i = 0; i < trace.prune.clusters.size(); ++i) {
    const auto members = trace.prune.clusters[i];
    std::vector<PointD> points;
    std::vector<SegmentId> segments;
    for (const VertexId v : members) {
      points.push_back(trace.raw.vertices[v]);
      segments.insert(segments.end(), segments_at[v].begin(), segments_at[v].end());
    }
    const VertexId merged = trace.prune.vertex_map[members.front()];
    result.add(cluster(std::move(points), trace.prune.vertices[merged]), segments);
  }
  result.sort();
  return result;
}

}  // namespace

PublishedRun::PublishedRun(const Trace& trace, PublishedResult result, std::size_t threads)
    : trace_(trace),
      result_(result),
      threads_(threads),
      raw_sources_(raw_sources(trace)),
      lar_sources_(lar_sources(trace, raw_sources_)),
      merged_(merged_in(trace, raw_sources_)),
      meetings_(trace),
      dropped_(trace, result, lar_sources_),
      walk_(walk_of(trace, result, kept_work(trace, result, lar_sources_), threads)),
      lattice_(trace, result, lar_sources_) {}

FloatComplex PublishedRun::complex() const { return result_complex(trace_, result_, lar_sources_); }

std::vector<StageOutput> PublishedRun::outputs() const {
  std::vector<StageOutput> result;
  LineWork lines = quantised_work(trace_);
  lines.segments = trace_.lines;
  result.push_back({Stage::Transform, 0, true, std::move(lines)});
  result.push_back({Stage::Quantise, 0, true, quantised_work(trace_)});
  const bool has_buckets = trace_.buckets.size() == trace_.lines.size() && !trace_.lines.empty();
  if (!has_buckets) {
    result.push_back({Stage::Bucket, 0, true, {}, true});
    return result;
  }
  result.push_back({Stage::Intersect, 0, true, work_of(trace_.raw, raw_sources_), true});
  result.push_back({Stage::Prune, 0, true, work_of(trace_.lar, lar_sources_), true});
  if (has_result(trace_, result_) && result_ != PublishedResult::CellsFromCycles)
    result.push_back(
        {Stage::ComponentFilter, 0, true, kept_work(trace_, result_, lar_sources_), true});
  return result;
}

Stage PublishedRun::late_stage(const Finding& finding) const {
  if (finding.invariant == Invariant::Index) return Stage::Simplify;
  if (trace_.components.empty()) return Stage::Simplify;  // what edges of one vertex add
  if (result_ == PublishedResult::CellsFromCycles) return Stage::Nesting;
  if (!has_result(trace_, result_) || walk_.is_faulty() || !walk_.is_plane) return Stage::FaceWalk;
  if (walk_.misorders_edges) return Stage::EdgeOrder;
  const bool is_about_nesting =
      finding.kind == CellKind::Hole || finding.disagreement == Disagreement::WrongParent;
  return is_about_nesting ? Stage::Nesting : Stage::OuterFace;
}

std::optional<FloatComplex> PublishedRun::with_exact(Stage stage, std::size_t /*round*/) const {
  return run_with_exact(trace_, result_, raw_sources_, lar_sources_, stage, threads_);
}

void blame_missed_junctions(Crosscheck& result, const ExactComplex& exact_complex,
                            const PublishedRun& run) {
  std::vector<Finding*> dropped;
  for (Finding& finding : result.findings)
    if (finding.cause->rule == "bridges-dropped") dropped.push_back(&finding);
  if (dropped.empty()) return;
  const auto replaced = run.with_exact(Stage::Intersect, 0);
  if (!replaced) return;
  const Crosscheck now = crosscheck(exact_complex, *replaced, result.tolerance);
  const WrongCells wrong(now, exact_complex);
  for (Finding* finding : dropped) {
    if (wrong.has(*finding)) continue;
    Cause cause;
    cause.stage = Stage::Intersect;
    cause.confirmed = true;
    cause.remade = false;
    run.explain(*finding, cause);
    finding->cause = cause;
  }
}

}  // namespace plumbline::checking
