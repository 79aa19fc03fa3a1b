#include "engines/plasm/explain/replaced_stage.hpp"

#include <algorithm>

#include "engines/lar/explain/cells.hpp"
#include "engines/plasm/explain/result.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

/// The exact arrangement of a graph, rounded.
Graph arranged(const Graph& graph, std::size_t threads) {
  const FloatComplex complex = nearest(arrange(line_work(graph), threads));
  Graph result;
  result.vertices = complex.vertices;
  for (const Edge& edge : complex.edges) {
    result.edges.push_back({std::min(edge.tail, edge.head), std::max(edge.tail, edge.head)});
  }
  result.edge_sources = complex.edge_sources;
  return result;
}

FloatComplex continued(Trace trace, const Graph& fragments, double radius) {
  trace.merging = merge(fragments, radius);
  find_cells(trace);
  return result_complex(trace);
}

}  // namespace

LineWork merged_work(const Trace& trace) {
  LineWork work = line_work(trace.merging.graph);
  work.points = trace.points;
  return work;
}

FloatComplex run_with_exact(const Trace& trace, Stage stage, std::size_t threads) {
  switch (stage) {
    case Stage::Fragment:
      return continued(trace, arranged(trace.drawing, threads), trace.radius);
    case Stage::Merge:
      return continued(trace, arranged(trace.fragments, threads), 0);
    case Stage::ComponentFilter:
      return nearest(lar::cells_of(merged_work(trace), threads));
    default:
      return nearest(lar::cells_of(kept_work(trace), threads));
  }
}

}  // namespace plumbline::plasm
