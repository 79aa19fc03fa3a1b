// The trace of the float LAR pipeline (variant repaired) as JSON.

#include "engines/lar/show/trace_writer.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline {
namespace {

using lar::Graph;
using VertexIds = std::array<VertexId, 2>;

std::vector<VertexIds> pairs(std::span<const Edge> edges) {
  std::vector<VertexIds> result;
  result.reserve(edges.size());
  for (const Edge& e : edges) result.push_back({e.tail, e.head});
  return result;
}

void write_graph(TraceWriter& json, const char* key, const Graph& graph) {
  json.Key(key);
  json.StartObject();
  json.member("V", graph.vertices);
  json.member("EV", pairs(graph.edges));
  json.member("segments", graph.edge_sources);
  json.EndObject();
}

void write_cuts(TraceWriter& json, const Lists<lar::Cut>& cuts) {
  json.Key("params");
  json.StartArray();
  for (std::size_t e = 0; e < cuts.size(); ++e) {
    std::vector<double> parameters;
    for (const lar::Cut& cut : cuts[e]) parameters.push_back(cut.parameter);
    json.value(parameters);
  }
  json.EndArray();
  std::vector<PointD> points;
  for (const lar::Cut& cut : cuts.flat()) points.push_back(cut.point);
  json.member("cutPoints", points);
}

void write_round(TraceWriter& json, const lar::Round& round) {
  json.StartObject();
  json.member("boxes", round.boxes);
  json.member("buckets", round.buckets);
  write_cuts(json, round.cuts);
  write_graph(json, "raw", round.split);
  json.Key("prune");
  json.StartObject();
  json.member("V", round.pruning.vertices);
  json.member("vmap", round.pruning.vertex_map);
  json.member("clusters", round.pruning.clusters);
  json.EndObject();
  write_graph(json, "lar", round.simplified);
  json.EndObject();
}

/// Signed edges counted from 1: k runs along edge k - 1, -k against it.
std::vector<std::ptrdiff_t> signed_edges(std::span<const HalfedgeId> halfedges) {
  std::vector<std::ptrdiff_t> result;
  for (const HalfedgeId h : halfedges) {
    const auto number = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(edge_of(h))) + 1;
    result.push_back(is_reversed(h) ? -number : number);
  }
  return result;
}

void write_signed(TraceWriter& json, const char* key, const Lists<HalfedgeId>& lists) {
  json.Key(key);
  json.StartArray();
  for (std::size_t i = 0; i < lists.size(); ++i) json.value(signed_edges(lists[i]));
  json.EndArray();
}

std::vector<VertexIds> pairs(const Graph& graph, std::span<const EdgeId> edges) {
  std::vector<Edge> chosen;
  for (const EdgeId e : edges) chosen.push_back(graph.edges[e]);
  return pairs(chosen);
}

void write_components(TraceWriter& json, const lar::Trace& trace, const Graph& graph) {
  json.Key("components");
  json.StartArray();
  for (std::size_t c = 0; c < trace.biconnected.size(); ++c) {
    json.value(pairs(graph, trace.biconnected[c]));
  }
  json.EndArray();
  json.member("bridges", pairs(graph, trace.bridges));
}

std::vector<VertexId> vertices_of(const FloatComplex& complex, CycleId cycle) {
  std::vector<VertexId> result;
  for (const HalfedgeId h : complex.cycles[cycle]) result.push_back(complex.origin(h));
  return result;
}

/// The bounded faces: FV the vertices of the outer boundaries, `polygons` these and the holes.
void write_result(TraceWriter& json, const FloatComplex& complex) {
  std::vector<std::vector<VertexId>> outer;
  std::vector<std::vector<std::vector<VertexId>>> polygons;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    outer.push_back(vertices_of(complex, complex.face_outer[f]));
    polygons.push_back({outer.back()});
    for (const CycleId hole : complex.face_holes[f]) {
      polygons.back().push_back(vertices_of(complex, hole));
    }
  }
  json.Key("larFromLines");
  json.StartObject();
  json.member("V", complex.vertices);
  json.member("FV", outer);
  json.member("EV", pairs(complex.edges));
  json.member("polygons", polygons);
  json.EndObject();
}

}  // namespace

std::string to_json(const lar::Result& result) {
  const lar::Trace& trace = result.trace;
  const Graph& graph = trace.rounds.back().simplified;
  TraceWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline lar 1");
  json.Key("variant");
  json.text("repaired");
  json.member("radius", trace.radius);
  json.member("exponent", trace.exponent);
  json.Key("settled");
  json.Bool(trace.settled);
  write_graph(json, "input", trace.drawing);
  json.Key("outputs");
  json.StartObject();
  json.Key("rounds");
  json.StartArray();
  for (const lar::Round& round : trace.rounds) write_round(json, round);
  json.EndArray();
  write_components(json, trace, graph);
  write_signed(json, "VE", trace.edge_order);
  write_signed(json, "cycles", trace.cycles);
  json.member("areas", trace.cycle_areas);
  write_result(json, result.complex);
  json.EndObject();
  json.Key("errors");
  json.StartObject();
  json.EndObject();
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
