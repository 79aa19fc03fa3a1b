// The published pipeline, stage after stage. A stage that fails is recorded, and those that need it
// are left out.

#include <algorithm>
#include <functional>

#include "engines/inters/stages/fail.hpp"
#include "engines/lar/stages/parallel.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inters {
namespace {

using lar::on_threads;

/// Runs one stage; false where it failed.
bool attempt(Trace& trace, const char* stage, const std::function<void()>& run_stage) {
  try {
    run_stage();
    return true;
  } catch (const StageFailure& failed) {
    trace.failures.push_back(failed.failure());
    trace.failures.back().stage = stage;
    return false;
  }
}

template <class T, class Run>
Outcome<T> outcome(const char* stage, const Run& run_stage) {
  try {
    return {run_stage(), std::nullopt};
  } catch (const StageFailure& failed) {
    Outcome<T> result{std::nullopt, failed.failure()};
    result.failure->stage = stage;
    return result;
  }
}

void trace_faces(Trace& trace, const Vcode& vcode) {
  if (!trace.components.empty()) {
    const bool found = attempt(trace, "larFromLines", [&] {
      trace.largest = largest_component_faces(trace.lar, trace.components, vcode);
    });
    if (found) trace.lar_from_lines = without_exterior(*trace.largest);
  }
  attempt(trace, "allComponents",
          [&] { trace.all_components = all_component_faces(trace.lar, trace.components, vcode); });
}

void trace_boundaries(Trace& trace, const Vcode& vcode) {
  for (const std::vector<VertexPair>& component : trace.components) {
    trace.boundary_polylines.push_back(outcome<std::vector<Polyline>>("boundaryPolylines", [&] {
      return boundary_polylines(trace.lar.vertices, component, vcode);
    }));
    trace.boundary_cycles.push_back(outcome<std::vector<SignedCycle>>(
        "boundaryCycles", [&] { return boundary_cycles(component); }));
  }
}

/// The face's vertices as a cycle of edges.
std::vector<VertexPair> edges_of_face(std::span<const VertexId> face) {
  std::vector<VertexPair> edges;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto [first, second] = std::minmax(face[i], face[(i + 1) % face.size()]);
    edges.push_back({first, second});
  }
  return edges;
}

void trace_simple_cycles(Trace& trace, const Vcode& vcode) {
  SimpleCycles simple;
  std::vector<std::vector<VertexPair>> cycles;
  for (std::size_t c = 0; c < trace.components.size(); ++c) {
    if (!trace.boundary_polylines[c].value) continue;
    simple.components.push_back(c);
    cycles.push_back(trace.components[c]);
  }
  if (cycles.empty()) return;
  simple.lattice = lattice_array(trace.lar.vertices, cycles, vcode);
  simple.cells = cells_from_cycles(simple.lattice);
  trace.simple_cycles = std::move(simple);
}

/// Whether there are few enough cycles to compare each with each; a failure where not.
bool is_within_limit(Trace& trace, const char* stage, std::size_t cycles) {
  if (cycles > kMaxLattice) {
    trace.failures.push_back({stage, "Limit", "more than 1000 cycles", "run"});
  }
  return cycles <= kMaxLattice;
}

void trace_components_lattice(Trace& trace, const Vcode& vcode) {
  if (trace.components.empty()) return;
  if (!is_within_limit(trace, "latticeArray", trace.components.size())) return;
  const bool are_simple = attempt(trace, "latticeArray", [&] {
    trace.lattice = lattice_array(trace.lar.vertices, trace.components, vcode);
  });
  if (are_simple) {
    trace.cells = cells_from_cycles(*trace.lattice);
    trace.two_complex = two_complex(trace.lar, trace.components, *trace.cells);
    trace.bridge_edges = bridge_edges(trace.lar.vertices, trace.components, *trace.cells);
  }
  if (!are_simple) trace_simple_cycles(trace, vcode);
}

void trace_faces_lattice(Trace& trace, const Vcode& vcode) {
  if (!trace.lar_from_lines) return;
  const std::size_t n = trace.lar_from_lines->faces.size();
  if (n < 2 || !is_within_limit(trace, "facesLattice", n)) return;
  const Model& result = *trace.lar_from_lines;
  std::vector<std::vector<VertexPair>> faces;
  for (std::size_t f = 0; f < result.faces.size(); ++f) {
    faces.push_back(edges_of_face(result.faces[f]));
  }
  attempt(trace, "facesLattice",
          [&] { trace.faces_lattice = lattice_array(result.vertices, faces, vcode); });
}

void run_stages(Trace& trace, const Vcode& vcode) {
  trace.boxes = containment_boxes(trace.lines, vcode);
  const bool in_buckets =
      attempt(trace, "buckets", [&] { trace.buckets = box_buckets(trace.boxes); });
  if (!in_buckets) return;
  Intersections found = line_intersection(trace.lines, trace.boxes, trace.buckets, vcode);
  trace.intersection_points = std::move(found.points);
  trace.fragments = std::move(found.fragments);
  Split pieces = split(trace.fragments, vcode);
  trace.raw = std::move(pieces.model);
  trace.raw_edge_count_with_duplicates = pieces.edge_count_with_duplicates;
  trace.prune = prune_vertices(trace.raw.vertices, trace.options.radius);
  trace.lar = simplify(trace.raw, trace.prune);
  const bool has_components = attempt(trace, "components", [&] {
    Biconnected biconnected = biconnected_components(trace.lar);
    trace.components = std::move(biconnected.components);
    trace.bridges = std::move(biconnected.bridges);
  });
  if (!has_components) return;
  trace_faces(trace, vcode);
  trace_boundaries(trace, vcode);
  trace_components_lattice(trace, vcode);
  trace_faces_lattice(trace, vcode);
}

}  // namespace

std::vector<SegmentD> lines(const SegmentSet& input) {
  std::vector<SegmentD> result;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const Segment& segment = input.segments[i];
    result.push_back({nearest(segment.a), nearest(segment.b)});
  }
  return result;
}

std::vector<SegmentD> lines_on_unit_square(const SegmentSet& input, int decimals) {
  const Vcode vcode(decimals);
  const std::vector<SegmentD> drawn = lines(input);
  if (drawn.empty()) return {};
  try {
    return to_unit_square(drawn, vcode);
  } catch (const StageFailure& failed) {
    throw Error(ErrorCode::BadInput,
                "the published map to the unit square needs a drawing with width and height", {},
                failed.failure().message);
  }
}

Trace run(std::vector<SegmentD> lines, const Options& options) {
  check_radius(options.radius);
  const Vcode vcode(options.decimals);
  Trace trace;
  trace.options = options;
  trace.lines = std::move(lines);
  on_threads(options.threads, [&] { run_stages(trace, vcode); });
  return trace;
}

}  // namespace plumbline::inters
