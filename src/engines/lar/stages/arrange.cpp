#include <cmath>

#include "engines/lar/stages/parallel.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {

Round resolve(const Graph& graph, double radius) {
  Round round;
  // Two edges that are within the radius have boxes that meet when each grows by half of it; by all
  // of it no rounding can part them.
  round.boxes = containment_boxes(graph, radius);
  round.buckets = refine_buckets(graph, box_buckets(round.boxes), radius);
  round.cuts = cut_edges(graph, round.boxes, round.buckets, radius);
  round.split = split_edges(graph, round.cuts);
  round.pruning = prune_vertices(round.split.vertices, radius);
  round.simplified = simplify(round.split, round.pruning);
  return round;
}

namespace {

FloatComplex scaled(FloatComplex complex, int exponent) {
  if (exponent == 0) return complex;
  for (PointD& p : complex.vertices) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return complex;
}

FloatComplex walk_faces(const Graph& graph, Trace& trace) {
  trace.edge_order = edge_slope_ordering(graph);
  trace.cycles = face_cycles(graph, trace.edge_order);
  trace.cycle_areas = cycle_areas(graph, trace.cycles);
  const std::vector<Exterior> exteriors = exterior_cycles(graph, trace.edge_order, trace.cycles);
  return cells(graph, trace.cycles, exteriors, trace.cycle_areas);
}

Result arrange_here(const SegmentSet& input, const Options& options) {
  Drawing drawing = to_doubles(input, options);
  Result result;
  Trace& trace = result.trace;
  trace.radius = std::ldexp(drawing.radius, drawing.exponent);
  trace.radius_from_segment = drawing.radius_from_segment;
  trace.exponent = drawing.exponent;
  trace.drawing = std::move(drawing.graph);
  // Merging moves vertices, so edges may cross or pass near vertices again: until nothing does.
  while (!trace.settled && trace.rounds.size() < kMaxRounds) {
    const Graph& last = trace.rounds.empty() ? trace.drawing : trace.rounds.back().simplified;
    Round round = resolve(last, drawing.radius);
    trace.settled = round.idle();
    trace.rounds.push_back(std::move(round));
  }
  const Graph& graph = trace.rounds.back().simplified;

  Biconnected biconnected = biconnected_components(graph);
  trace.biconnected = std::move(biconnected.components);
  trace.bridges = std::move(biconnected.bridges);
  result.complex = canonical(scaled(walk_faces(graph, trace), trace.exponent));
  return result;
}

}  // namespace

FloatComplex faces(const Graph& graph) {
  Trace trace;
  return walk_faces(graph, trace);
}

Result arrange(const SegmentSet& input, const Options& options) {
  Result result;
  on_threads(options.threads, [&] { result = arrange_here(input, options); });
  return result;
}

}  // namespace plumbline::lar
