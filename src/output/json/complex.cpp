#include "output/json/rounding.hpp"
#include "output/json/writer.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// What else is written of a complex whose coordinates are rounded.
struct Rounded {
  const ExactComplex& exact;
  const Grid& grid;
  const Rounding& rounding;
};

/// The numbers beside the exact coordinates of vertex v of the written complex.
void write_nearest(JsonWriter& json, const Point& p, VertexId v, const Rounded* rounded) {
  const Point* to = &p;
  if (rounded != nullptr && rounded->rounding.has_same_incidences())
    to = &rounded->rounding.complex.vertices[rounded->rounding.vertex_image[v]];
  json.StartArray();
  for (const Rational* coordinate : {&to->x, &to->y}) {
    if (rounded != nullptr && rounded->grid.decimals) {
      json.whole_decimal(*coordinate);
    } else {
      json.number(nearest_double(*coordinate));
    }
  }
  json.EndArray();
}

void write_vertices(JsonWriter& json, const ExactComplex& c, const Rounded* rounded) {
  json.Key("vertices");
  json.StartArray();
  for (std::size_t v = 0; v < c.vertices.size(); ++v) {
    json.StartObject();
    json.Key("exact");
    json.point(c.vertices[v]);
    json.Key("nearest");
    write_nearest(json, c.vertices[v], VertexId(v), rounded);
    json.EndObject();
  }
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

void write_face(JsonWriter& json, const ExactComplex& c, FaceId f, const Rational& area) {
  json.StartObject();
  json.Key("outer");
  if (c.face_outer[f].valid()) {
    write_signed_edges(json, c.cycles[c.face_outer[f]]);
  } else {
    json.Null();
  }
  json.Key("holes");
  json.StartArray();
  for (const CycleId hole : c.face_holes[f]) write_signed_edges(json, c.cycles[hole]);
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

std::string document(const ExactComplex& complex, const SegmentSet& input, const Rounded* rounded) {
  JsonWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline arrangement 1");
  json.Key("signature");
  json.text(signature(complex));
  json.Key("exact");
  json.Bool(input.ledger.empty() &&
            (rounded == nullptr || rounded->rounding.has_same_incidences()));
  if (rounded != nullptr) write_rounding(json, rounded->exact, rounded->grid, rounded->rounding);
  write_vertices(json, complex, rounded);
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

}  // namespace

void write_signed_edges(JsonWriter& json, std::span<const HalfedgeId> halfedges) {
  json.StartArray();
  for (const HalfedgeId h : halfedges) {
    const auto number = static_cast<std::int64_t>(static_cast<std::size_t>(edge_of(h))) + 1;
    json.Int64(is_reversed(h) ? -number : number);
  }
  json.EndArray();
}

std::string to_json(const ExactComplex& complex, const SegmentSet& input) {
  return document(complex, input, nullptr);
}

std::string to_json(const ExactComplex& complex, const SegmentSet& input, const Grid& grid,
                    const Rounding& rounding) {
  const Rounded rounded{complex, grid, rounding};
  return document(rounding.has_same_incidences() ? complex : rounding.complex, input, &rounded);
}

}  // namespace plumbline
