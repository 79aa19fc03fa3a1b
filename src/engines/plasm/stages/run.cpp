// Plasm.jl's 2D arrangement, stage after stage.

#include <cmath>

#include "plumbline/engines/plasm_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::plasm {
namespace {

void find_faces(Trace& trace) {
  if (trace.components.empty()) {
    throw Failure{Failure::Kind::NoCycle,
                  "planar_arrangement returns nothing: no edge is in a "
                  "cycle"};
  }
  const Graph& graph = trace.merging.graph;
  for (const std::vector<EdgeId>& edges : trace.components) {
    Component component{edges, minimal_cycles(graph, edges), {}};
    const std::size_t unbounded = unbounded_face(graph, edges, component.faces);
    component.shell = std::move(component.faces[unbounded]);
    component.faces.erase(component.faces.begin() + static_cast<std::ptrdiff_t>(unbounded));
    trace.cells.push_back(std::move(component));
  }
  trace.holes = nest(graph, trace.cells);
}

}  // namespace

void find_cells(Trace& trace) {
  Biconnected biconnected = biconnected_components(trace.merging.graph);
  trace.components = std::move(biconnected.components);
  trace.dropped = std::move(biconnected.dropped);
  trace.cells.clear();
  trace.holes.clear();
  trace.failure.reset();
  try {
    find_faces(trace);
  } catch (const Failure& failure) {
    trace.failure = failure;
  }
}

Trace run(const SegmentSet& input, double radius) {
  if (!(std::isfinite(radius) && radius >= 0)) {
    throw Error(ErrorCode::BadInput, "the radius must be finite and not negative", {},
                shortest_text(radius));
  }
  Trace trace;
  trace.radius = radius;
  trace.drawing = to_doubles(input);
  for (const Point& point : input.points) trace.points.push_back(nearest(point));
  trace.fragments = fragment(trace.drawing, radius);
  trace.merging = merge(trace.fragments, radius);
  find_cells(trace);
  return trace;
}

}  // namespace plumbline::plasm
