// The trace of the published LAR pipeline as JSON, with the keys of the original's outputs.

#include "engines/lar/show/trace_writer.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline {
namespace {

using namespace inters;

void write_intersections(TraceWriter& json, const Trace& trace) {
  json.member("buckets", trace.buckets);
  json.member("intersectionPoints", trace.intersection_points);
  std::vector<SegmentD> segments;
  std::vector<std::vector<double>> parameters;
  for (const Fragment& fragment : trace.fragments) {
    segments.push_back(fragment.segment);
    parameters.push_back(fragment.parameters);
  }
  json.member("frags", segments);
  json.member("params", parameters);
}

void write_one_complex(TraceWriter& json, const Trace& trace) {
  json.Key("raw");
  json.StartObject();
  json.member("V", trace.raw.vertices);
  json.member("EV", trace.raw.edges);
  json.member("EV_count_with_duplicates", trace.raw_edge_count_with_duplicates);
  json.EndObject();
  json.Key("prune");
  json.StartObject();
  json.member("V", trace.prune.vertices);
  json.member("vmap", trace.prune.vertex_map);
  json.member("clusters", trace.prune.clusters);
  json.member("close", trace.prune.close);
  json.EndObject();
  json.Key("lar");
  json.StartObject();
  json.member("V", trace.lar.vertices);
  json.Key("EV");
  json.StartArray();
  for (const VertexPair& edge : trace.lar.edges) {
    json.value(std::span(edge).first(edge[0] == edge[1] ? 1 : 2));
  }
  json.EndArray();
  json.EndObject();
}

void write_model(TraceWriter& json, const Model& model) {
  json.member("V", model.vertices);
  json.member("FV", model.faces);
  json.member("EV", model.edges);
}

void write_faces(TraceWriter& json, const Faces& faces) {
  write_model(json, faces.model);
  json.member("areas", faces.areas);
  json.Key("aborted");
  json.Bool(faces.aborted);
}

void write_two_complexes(TraceWriter& json, const Trace& trace) {
  json.member("components", trace.components);
  json.member("bridges", trace.bridges);
  if (trace.largest) {
    json.Key("largest");
    json.StartObject();
    write_faces(json, *trace.largest);
    json.EndObject();
  }
  if (trace.lar_from_lines) {
    json.Key("larFromLines");
    json.StartObject();
    write_model(json, *trace.lar_from_lines);
    json.EndObject();
  } else if (trace.components.empty()) {
    json.Key("larFromLines");
    json.Null();
  }
  if (trace.all_components) {
    json.Key("allComponents");
    json.StartObject();
    write_faces(json, trace.all_components->faces);
    json.Key("FV_interior");
    json.StartArray();
    for (const std::size_t f : trace.all_components->interior) {
      json.value(trace.all_components->faces.model.faces[f]);
    }
    json.EndArray();
    json.EndObject();
  }
}

void write_cycles(TraceWriter& json, const Trace& trace) {
  json.member("boundaryPolylines", trace.boundary_polylines);
  json.member("boundaryCycles", trace.boundary_cycles);
  if (trace.lattice) json.member("latticeArray", *trace.lattice);
  if (trace.cells) json.member("cellsFromCycles", *trace.cells);
  if (trace.two_complex) {
    json.Key("twoComplex");
    json.StartObject();
    write_model(json, *trace.two_complex);
    json.EndObject();
  }
  if (trace.bridge_edges) json.member("bridgeEdges", *trace.bridge_edges);
  if (trace.simple_cycles) {
    json.Key("simpleCycles");
    json.StartObject();
    json.member("components", trace.simple_cycles->components);
    json.member("latticeArray", trace.simple_cycles->lattice);
    json.member("cellsFromCycles", trace.simple_cycles->cells);
    json.EndObject();
  }
  if (trace.faces_lattice) json.member("facesLattice", *trace.faces_lattice);
}

bool has_failed(const Trace& trace, std::string_view stage) {
  for (const Failure& failure : trace.failures)
    if (failure.stage == stage) return true;
  return false;
}

void write_outputs(TraceWriter& json, const Trace& trace) {
  json.member("boxes", trace.boxes);
  if (has_failed(trace, "buckets")) return;
  write_intersections(json, trace);
  write_one_complex(json, trace);
  if (has_failed(trace, "components")) return;
  write_two_complexes(json, trace);
  write_cycles(json, trace);
}

}  // namespace

std::string to_json(const Trace& trace) {
  TraceWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline lar 1");
  json.Key("variant");
  json.text("published");
  json.member("decimals", trace.options.decimals);
  json.member("radius", trace.options.radius);
  json.Key("input");
  json.StartObject();
  json.member("lines", trace.lines);
  json.EndObject();
  json.Key("outputs");
  json.StartObject();
  write_outputs(json, trace);
  json.EndObject();
  json.Key("errors");
  json.StartObject();
  for (const Failure& failure : trace.failures) json.member(failure.stage.c_str(), failure);
  json.EndObject();
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
