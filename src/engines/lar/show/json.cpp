// The trace of the float LAR pipeline as JSON.

#include "output/json/signed_edges.hpp"
#include "output/json/writer.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline {
namespace json {
namespace {

auto ends(const Edge& edge) { return std::array{edge.tail, edge.head}; }

auto graph(const lar::Graph& g) {
  return object(member("V", g.vertices), member("EV", list(g.edges, ends)),
                member("segments", g.edge_sources));
}

auto round(const lar::Round& r) {
  const auto parameters = [&r](std::size_t e) {
    return list(r.cuts[e], [](const lar::Cut& cut) { return cut.parameter; });
  };
  const auto point = [](const lar::Cut& cut) { return cut.point; };
  return object(
      member("boxes", r.boxes), member("buckets", r.buckets),
      member("params", list(r.cuts.size(), parameters)),
      member("cutPoints", list(r.cuts.flat(), point)), member("raw", graph(r.split)),
      member("prune", object(member("V", r.pruning.vertices), member("vmap", r.pruning.vertex_map),
                             member("clusters", r.pruning.clusters))),
      member("lar", graph(r.simplified)));
}

auto edges(const lar::Graph& graph, std::span<const EdgeId> chosen) {
  return list(chosen, [&graph](EdgeId e) { return ends(graph.edges[e]); });
}

auto walks(const Lists<HalfedgeId>& lists) {
  return list(lists.size(), [&lists](std::size_t i) { return signed_edges(lists[i]); });
}

/// The bounded faces: FV the vertices of the outer boundaries, `polygons` these and the holes.
auto faces(const FloatComplex& c) {
  const auto vertices = [&c](CycleId cycle) {
    return list(c.cycles[cycle], [&c](HalfedgeId h) { return c.origin(h); });
  };
  const auto outer = [&c, vertices](std::size_t f) { return vertices(c.face_outer[f]); };
  const auto polygon = [&c, vertices](std::size_t f) {
    std::vector<CycleId> cycles{c.face_outer[f]};
    cycles.insert(cycles.end(), c.face_holes[f].begin(), c.face_holes[f].end());
    return list(std::move(cycles), vertices);
  };
  const auto bounded = Numbers(1, c.face_count());
  return object(member("V", c.vertices), member("FV", list(bounded, outer)),
                member("EV", list(c.edges, ends)), member("polygons", list(bounded, polygon)));
}

auto outputs(const lar::Trace& trace, const FloatComplex& complex) {
  const lar::Graph& graph = trace.rounds.back().simplified;
  const auto component = [&](std::size_t c) { return edges(graph, trace.biconnected[c]); };
  return object(member("rounds", list(trace.rounds, round)),
                member("components", list(trace.biconnected.size(), component)),
                member("bridges", edges(graph, trace.bridges)),
                member("VE", walks(trace.edge_order)), member("cycles", walks(trace.cycles)),
                member("areas", trace.cycle_areas), member("larFromLines", faces(complex)));
}

}  // namespace
}  // namespace json

std::string to_json(const lar::Result& result) {
  using namespace json;
  const lar::Trace& trace = result.trace;
  return document(object(member("format", "plumbline lar 1"), member("variant", "repaired"),
                         member("radius", trace.radius), member("exponent", trace.exponent),
                         member("settled", trace.settled), member("input", graph(trace.drawing)),
                         member("outputs", outputs(trace, result.complex)),
                         member("errors", object())));
}

}  // namespace plumbline
