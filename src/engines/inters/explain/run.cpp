// What attribution asks of a run of the published pipeline; the rules are in published_rules.cpp.

#include "engines/inters/explain/run.hpp"

#include <algorithm>

#include "engines/inters/explain/replaced_stage.hpp"
#include "engines/lar/explain/cells.hpp"

namespace plumbline::inters {
namespace {

/// The clusters of the run, with the segments at their members.
engine_steps::MergedVertices merged_in(const Trace& trace, const EdgeSources& raw_sources) {
  std::vector<std::vector<SegmentId>> segments_at(trace.raw.vertices.size());
  std::vector<bool> is_merged(trace.raw.vertices.size());
  for (const VertexId v : trace.prune.clusters.flat()) is_merged[v] = true;
  for (const auto& [edge, sources] : raw_sources) {
    for (const VertexId v : edge) {
      if (is_merged[v]) segments_at[v].insert(segments_at[v].end(), sources.begin(), sources.end());
    }
  }
  engine_steps::MergedVertices result;
  for (std::size_t i = 0; i < trace.prune.clusters.size(); ++i) {
    const auto members = trace.prune.clusters[i];
    std::vector<PointD> points;
    std::vector<SegmentId> segments;
    for (const VertexId v : members) {
      points.push_back(trace.raw.vertices[v]);
      segments.insert(segments.end(), segments_at[v].begin(), segments_at[v].end());
    }
    const VertexId merged = trace.prune.vertex_map[members.front()];
    result.add(engine_steps::cluster(std::move(points), trace.prune.vertices[merged]), segments);
  }
  result.sort();
  return result;
}

}  // namespace

ExplainedRun::ExplainedRun(std::shared_ptr<const Trace> trace, Result result, std::size_t threads)
    : owner_(std::move(trace)),
      trace_(*owner_),
      result_(result),
      threads_(threads),
      raw_sources_(raw_sources(trace_)),
      lar_sources_(lar_sources(trace_, raw_sources_)),
      merged_(merged_in(trace_, raw_sources_)),
      meetings_(trace_),
      dropped_(trace_, result, lar_sources_),
      walk_(walk_of(trace_, result, kept_work(trace_, result, lar_sources_), threads)),
      lattice_(trace_, result, lar_sources_) {}

FloatComplex ExplainedRun::complex() const { return result_complex(trace_, result_, lar_sources_); }

std::vector<StageOutput> ExplainedRun::outputs() const {
  std::vector<StageOutput> result;
  const auto add = [&](Stage stage, LineWork work, bool is_cut) {
    result.push_back({to_text(stage), 0, true, std::move(work), stage == Stage::Intersect, is_cut});
  };
  LineWork lines = quantised_work(trace_);
  lines.segments = trace_.lines;
  add(Stage::Transform, std::move(lines), false);
  add(Stage::Quantise, quantised_work(trace_), false);
  const bool has_buckets = trace_.buckets.size() == trace_.lines.size() && !trace_.lines.empty();
  if (!has_buckets) {
    add(Stage::Bucket, {}, true);
    return result;
  }
  add(Stage::Intersect, work_of(trace_.raw, raw_sources_), true);
  add(Stage::Prune, work_of(trace_.lar, lar_sources_), true);
  if (has_result(trace_, result_) && result_ != Result::CellsFromCycles) {
    add(Stage::ComponentFilter, kept_work(trace_, result_, lar_sources_), true);
  }
  return result;
}

ExactComplex ExplainedRun::continued(const StageOutput& output, std::size_t threads) const {
  return output.is_cut ? lar::cells_of(output.work, threads) : arrange(output.work, threads);
}

std::string ExplainedRun::late_stage(const Finding& finding) const {
  const bool is_about_nesting =
      finding.kind == CellKind::Hole || finding.disagreement == Disagreement::WrongParent;
  if (finding.invariant == Invariant::Index) return to_text(Stage::Simplify);
  // What edges of one vertex add.
  if (trace_.components.empty()) return to_text(Stage::Simplify);
  if (result_ == Result::CellsFromCycles) return to_text(Stage::Nesting);
  if (!has_result(trace_, result_) || walk_.is_faulty() || !walk_.is_plane) {
    return to_text(Stage::FaceWalk);
  }
  if (walk_.misorders_edges) return to_text(Stage::EdgeOrder);
  return to_text(is_about_nesting ? Stage::Nesting : Stage::OuterFace);
}

std::optional<FloatComplex> ExplainedRun::with_exact(const std::string& stage,
                                                     std::size_t /*round*/) const {
  return run_with_exact(trace_, result_, raw_sources_, lar_sources_, stage_of(stage), threads_);
}

std::optional<std::string> ExplainedRun::suspect(const Cause& cause) const {
  if (cause.rule != "bridges-dropped") return std::nullopt;
  return to_text(Stage::Intersect);
}

}  // namespace plumbline::inters
