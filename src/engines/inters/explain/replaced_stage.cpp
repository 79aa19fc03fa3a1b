#include "engines/inters/explain/replaced_stage.hpp"

#include <algorithm>
#include <numeric>

#include "engines/lar/explain/cells.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::inters {
namespace {

using lar::VertexPair;

/// A run as far as it got, with the sources of its edges.
struct Rerun {
  Trace trace;
  EdgeSources raw_sources;
  EdgeSources sources;
};

/// The buckets of the repaired pipeline, as lists of partners.
Lists<SegmentId> all_partners(const std::vector<lar::Box>& boxes) {
  const Lists<EdgeId> buckets = lar::box_buckets(boxes);
  std::vector<std::vector<SegmentId>> partners(boxes.size());
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (const EdgeId e : buckets[b]) {
      for (const EdgeId f : buckets[b]) {
        if (e != f) partners[e].emplace_back(f);
      }
    }
  }
  Lists<SegmentId> result;
  for (std::vector<SegmentId>& list : partners) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    result.push_back(list);
  }
  return result;
}

/// The stages from the components on. What fails is left out, as in `run`.
void find_faces(Trace& trace, Result result) {
  const Vcode vcode(trace.options.decimals);
  trace.largest.reset();
  trace.lar_from_lines.reset();
  trace.all_components.reset();
  trace.cells.reset();
  try {
    if (result == Result::LarFromLines && !trace.components.empty()) {
      trace.largest = largest_component_faces(trace.lar, trace.components, vcode);
      trace.lar_from_lines = without_exterior(*trace.largest);
    } else if (result == Result::AllComponents) {
      trace.all_components = all_component_faces(trace.lar, trace.components, vcode);
    } else if (result == Result::CellsFromCycles && !trace.components.empty() &&
               trace.components.size() <= kMaxLattice) {
      trace.cells = cells_from_cycles(lattice_array(trace.lar.vertices, trace.components, vcode));
    }
  } catch (const StageFailure&) {
    return;
  }
}

void find_components(Trace& trace, Result result) {
  trace.components.clear();
  trace.bridges.clear();
  try {
    Biconnected found = biconnected_components(trace.lar);
    trace.components = std::move(found.components);
    trace.bridges = std::move(found.bridges);
  } catch (const StageFailure&) {
    // No edge: then there is no component either.
  }
  find_faces(trace, result);
}

void prune(Rerun& rerun, Result result) {
  Trace& trace = rerun.trace;
  trace.prune = prune_vertices(trace.raw.vertices, trace.options.radius);
  trace.lar = simplify(trace.raw, trace.prune);
  rerun.sources = lar_sources(trace, rerun.raw_sources);
  find_components(trace, result);
}

void without_quantisation(Rerun& rerun, Result result) {
  Trace& trace = rerun.trace;
  const Vcode rounded(trace.options.decimals);
  trace.options.decimals = kMaxDecimals;
  const Vcode fine(trace.options.decimals);
  trace.boxes = containment_boxes(trace.lines, fine);
  if (trace.lines.empty()) return;
  trace.buckets = all_partners(trace.boxes);
  trace.fragments = line_intersection(trace.lines, trace.boxes, trace.buckets, fine).fragments;
  for (Fragment& fragment : trace.fragments) {
    for (double& parameter : fragment.parameters) parameter = rounded.quantised(parameter);
    auto& all = fragment.parameters;
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  trace.raw = split(trace.fragments, fine).model;
  rerun.raw_sources = raw_sources(trace);
  prune(rerun, result);
}

void with_all_buckets(Rerun& rerun, Result result) {
  Trace& trace = rerun.trace;
  const Vcode vcode(trace.options.decimals);
  if (trace.lines.empty()) return;
  trace.buckets = all_partners(trace.boxes);
  trace.fragments = line_intersection(trace.lines, trace.boxes, trace.buckets, vcode).fragments;
  trace.raw = split(trace.fragments, vcode).model;
  rerun.raw_sources = raw_sources(trace);
  prune(rerun, result);
}

void with_exact_intersection(Rerun& rerun, Result result, std::size_t threads) {
  const FloatComplex exact_cut = nearest(arrange(quantised_work(rerun.trace), threads));
  Model raw{exact_cut.vertices, {}, {}};
  rerun.raw_sources.clear();
  for (std::size_t e = 0; e < exact_cut.edge_count(); ++e) {
    const auto [tail, head] = exact_cut.edges[e];
    raw.edges.push_back({tail, head});
    const auto sources = exact_cut.edge_sources[e];
    rerun.raw_sources[{tail, head}] = {sources.begin(), sources.end()};
  }
  rerun.trace.raw = std::move(raw);
  prune(rerun, result);
}

void without_merging(Rerun& rerun, Result result) {
  Trace& trace = rerun.trace;
  Pruned none;
  none.vertices = trace.raw.vertices;
  none.vertex_map.resize(none.vertices.size());
  for (std::size_t v = 0; v < none.vertices.size(); ++v) none.vertex_map[v] = VertexId(v);
  trace.prune = std::move(none);
  trace.lar = simplify(trace.raw, trace.prune);
  rerun.sources = lar_sources(trace, rerun.raw_sources);
  find_components(trace, result);
}

void without_points(Rerun& rerun, Result result) {
  std::erase_if(rerun.trace.lar.edges, [](const VertexPair& edge) { return edge[0] == edge[1]; });
  find_components(rerun.trace, result);
}

/// All edges make one component.
void without_filter(Rerun& rerun, Result result) {
  rerun.trace.components = {rerun.trace.lar.edges};
  rerun.trace.bridges.clear();
  find_faces(rerun.trace, result);
}

}  // namespace

std::optional<FloatComplex> run_with_exact(const Trace& trace, Result result,
                                           const EdgeSources& raw_sources,
                                           const EdgeSources& lar_sources, Stage stage,
                                           std::size_t threads) {
  Rerun rerun{trace, raw_sources, lar_sources};
  switch (stage) {
    case Stage::Quantise:
      without_quantisation(rerun, result);
      break;
    case Stage::Bucket:
      with_all_buckets(rerun, result);
      break;
    case Stage::Intersect:
      with_exact_intersection(rerun, result, threads);
      break;
    case Stage::Prune:
      without_merging(rerun, result);
      break;
    case Stage::Simplify:
      without_points(rerun, result);
      break;
    case Stage::ComponentFilter:
      without_filter(rerun, result);
      break;
    default:
      if (trace.raw.edges.empty()) return std::nullopt;
      return nearest(lar::cells_of(has_result(trace, result) ? kept_work(trace, result, lar_sources)
                                                             : work_of(trace.lar, lar_sources),
                                   threads));
  }
  return result_complex(rerun.trace, result, rerun.sources);
}

}  // namespace plumbline::inters
