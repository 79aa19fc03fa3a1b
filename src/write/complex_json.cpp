#include "plumbline/write.hpp"
#include "write/json_writer.hpp"

namespace plumbline {
namespace {

void write_vertices(JsonWriter& json, const ExactComplex& c) {
  json.Key("vertices");
  json.StartArray();
  for (const Point& p : c.vertices) json.place(p);
  json.EndArray();
}

void write_edges(JsonWriter& json, const ExactComplex& c) {
  json.Key("edges");
  json.StartArray();
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    json.StartObject();
    json.Key("tail");
    json.count(c.edges[e].tail);
    json.Key("head");
    json.count(c.edges[e].head);
    json.Key("antenna");
    json.Bool(c.is_antenna(EdgeId(e)));
    json.Key("segments");
    json.counts(c.edge_sources[e]);
    json.EndObject();
  }
  json.EndArray();
}

/// Signed edges counted from 1: k runs along edge k - 1, -k against it.
void write_cycle(JsonWriter& json, std::span<const HalfedgeId> cycle) {
  json.StartArray();
  for (const HalfedgeId h : cycle) {
    const auto number = static_cast<std::int64_t>(static_cast<std::size_t>(edge_of(h))) + 1;
    json.Int64(is_reversed(h) ? -number : number);
  }
  json.EndArray();
}

void write_face(JsonWriter& json, const ExactComplex& c, FaceId f, const Rational& area) {
  json.StartObject();
  json.Key("outer");
  if (c.face_outer[f].valid()) {
    write_cycle(json, c.cycles[c.face_outer[f]]);
  } else {
    json.Null();
  }
  json.Key("holes");
  json.StartArray();
  for (const CycleId hole : c.face_holes[f]) write_cycle(json, c.cycles[hole]);
  json.EndArray();
  json.Key("isolated_vertices");
  json.counts(c.face_isolated_vertices[f]);
  json.Key("depth");
  json.count(c.face_depth[f]);
  if (f != kUnbounded) {
    json.Key("parent");
    json.count(c.parent(f));
    json.Key("area");
    json.exact(area);
    json.Key("interior_point");
    json.point(interior_point(c, f));
  }
  json.EndObject();
}

}  // namespace

std::string to_json(const ExactComplex& complex, const SegmentSet& input) {
  JsonWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline arrangement 1");
  json.Key("signature");
  json.text(signature(complex));
  json.Key("exact");
  json.Bool(input.ledger.empty());
  write_vertices(json, complex);
  write_edges(json, complex);
  const std::vector<Rational> areas = face_areas(complex);
  json.Key("faces");
  json.StartArray();
  for (std::size_t f = 0; f < complex.face_count(); ++f)
    write_face(json, complex, FaceId(f), areas[f]);
  json.EndArray();
  json.Key("components");
  json.StartArray();
  for (const FaceId parent : complex.component_parent) {
    json.StartObject();
    json.Key("parent");
    json.count(parent);
    json.EndObject();
  }
  json.EndArray();
  write_input(json, input);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
