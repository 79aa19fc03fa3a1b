// The member "rounding" of a complex written with rounded coordinates: cells of the exact complex
// by their exact coordinates, cells of the rounded one by their numbers in the file.

#include "output/json/rounding.hpp"

namespace plumbline {
namespace {

const char* name(RoundingMethod method) {
  switch (method) {
    case RoundingMethod::NearestDoubles:
      return "nearest doubles";
    case RoundingMethod::NearestPoints:
      return "nearest points";
    case RoundingMethod::SnapRounded:
      return "snap rounded";
  }
  return "unknown";
}

class RoundingJson {
 public:
  RoundingJson(JsonWriter& json, const ExactComplex& exact, const Rounding& rounding)
      : json_(json), exact_(exact), rounding_(rounding), changes_(changes(exact, rounding)) {}

  void write(const Grid& grid) {
    json_.Key("rounding");
    json_.StartObject();
    member("grid", [&] { json_.text(to_text(grid)); });
    member("method", [&] { json_.text(name(rounding_.method)); });
    member("same_incidences", [&] { json_.Bool(rounding_.has_same_incidences()); });
    member("spacing", [&] { json_.exact(rounding_.spacing); });
    member("bound", [&] { json_.exact(rounding_.spacing / 2); });
    member("verified", [&] { json_.Bool(true); });  // else there was no Rounding
    if (grid.decimals) {
      member("valid_as_doubles",
             [&] { json_.Bool(is_kept_by_simple_rounding(rounding_.complex, {})); });
    }
    distance("largest_movement", changes_.largest_squared_movement());
    if (!rounding_.has_same_incidences()) write_changes();
    json_.EndObject();
  }

 private:
  template <class Write>
  void member(const char* key, Write write) {
    json_.Key(key);
    write();
  }

  template <class List, class Write>
  void list(const char* key, const List& items, Write write) {
    json_.Key(key);
    json_.StartArray();
    for (const auto& item : items) {
      json_.StartObject();
      write(item);
      json_.EndObject();
    }
    json_.EndArray();
  }

  void distance(const char* key, const Rational& squared) {
    json_.Key(key);
    json_.StartObject();
    member("squared", [&] { json_.exact(squared); });
    member("nearest", [&] { json_.number(nearest_sqrt(squared)); });
    json_.EndObject();
  }

  void edge(EdgeId e) {
    const Edge& edge = exact_.edges[e];
    member("from", [&] { json_.point(exact_.vertices[edge.tail]); });
    member("to", [&] { json_.point(exact_.vertices[edge.head]); });
    member("segments", [&] { json_.counts(exact_.edge_sources[e]); });
  }

  void face(FaceId f, const Rational& area) {
    member("interior_point", [&] { json_.point(interior_point(exact_, f)); });
    member("area", [&] { json_.exact(area); });
  }

  void write_changes() {
    using Changes = RoundingChanges;
    distance("largest_bend", changes_.largest_squared_bend());
    list("moved_vertices", changes_.moved_vertices, [&](const Changes::Movement& m) {
      member("vertex", [&] { json_.count(rounding_.vertex_image[m.vertex]); });
      member("from", [&] { json_.point(exact_.vertices[m.vertex]); });
      distance("distance", m.squared_distance);
    });
    list("merged_vertices", changes_.merged_vertices, [&](const Changes::MergedVertices& m) {
      member("vertex", [&] { json_.count(m.into); });
      json_.Key("from");
      json_.StartArray();
      for (const VertexId v : m.from) json_.point(exact_.vertices[v]);
      json_.EndArray();
    });
    list("bent_edges", changes_.bent_edges, [&](const Changes::Bend& b) {
      edge(b.edge);
      member("edges", [&] { write_signed_edges(json_, rounding_.edge_image[b.edge]); });
      distance("distance", b.squared_distance);
    });
    list("merged_edges", changes_.merged_edges, [&](const Changes::MergedEdges& m) {
      member("edge", [&] { json_.count(m.into); });
      list("from", m.from, [&](EdgeId e) { edge(e); });
    });
    list("vanished_edges", changes_.vanished_edges, [&](EdgeId e) { edge(e); });
    const std::vector<Rational> areas = face_areas(exact_);
    list("vanished_faces", changes_.vanished_faces, [&](FaceId f) { face(f, areas[f]); });
    list("split_faces", changes_.split_faces, [&](const Changes::SplitFace& s) {
      if (s.face != kUnbounded) face(s.face, areas[s.face]);
      member("into", [&] { json_.counts(s.into); });
    });
  }

  JsonWriter& json_;
  const ExactComplex& exact_;
  const Rounding& rounding_;
  const RoundingChanges changes_;
};

}  // namespace

void write_rounding(JsonWriter& json, const ExactComplex& exact, const Grid& grid,
                    const Rounding& rounding) {
  RoundingJson(json, exact, rounding).write(grid);
}

}  // namespace plumbline
