// The member "rounding" of a complex written with rounded coordinates: cells of the exact complex
// by their exact coordinates, cells of the rounded one by their numbers in the file.

#include "output/json/rounding.hpp"

#include "output/json/signed_edges.hpp"

namespace plumbline::json {
namespace {

using Changes = RoundingChanges;

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

auto distance(const Rational& squared) {
  return object(member("squared", Rational(squared)), member("nearest", nearest_sqrt(squared)));
}

auto edge_members(const ExactComplex& c, EdgeId e) {
  return members(member("from", c.vertices[c.edges[e].tail]),
                 member("to", c.vertices[c.edges[e].head]), member("segments", c.edge_sources[e]));
}

auto vertex_changes(const ExactComplex& exact, const Rounding& rounding, const Changes& changes) {
  const auto moved = [&](const Changes::Movement& m) {
    return object(member("vertex", rounding.vertex_image[m.vertex]),
                  member("from", exact.vertices[m.vertex]),
                  member("distance", distance(m.squared_distance)));
  };
  const auto merged = [&](const Changes::MergedVertices& m) {
    const auto place = [&exact](VertexId v) { return exact.vertices[v]; };
    return object(member("vertex", m.into), member("from", list(m.from, place)));
  };
  return members(member("moved_vertices", list(changes.moved_vertices, moved)),
                 member("merged_vertices", list(changes.merged_vertices, merged)));
}

auto edge_changes(const ExactComplex& exact, const Rounding& rounding, const Changes& changes) {
  const auto edge = [&exact](EdgeId e) { return object(edge_members(exact, e)); };
  const auto bent = [&](const Changes::Bend& b) {
    return object(edge_members(exact, b.edge),
                  member("edges", signed_edges(rounding.edge_image[b.edge])),
                  member("distance", distance(b.squared_distance)));
  };
  const auto merged = [edge](const Changes::MergedEdges& m) {
    return object(member("edge", m.into), member("from", list(m.from, edge)));
  };
  return members(member("bent_edges", list(changes.bent_edges, bent)),
                 member("merged_edges", list(changes.merged_edges, merged)),
                 member("vanished_edges", list(changes.vanished_edges, edge)));
}

auto face_changes(const ExactComplex& exact, const std::vector<Rational>& areas,
                  const Changes& changes) {
  const auto face_members = [&](FaceId f) {
    return members(member("interior_point", interior_point(exact, f)), member("area", areas[f]));
  };
  const auto vanished = [face_members](FaceId f) { return object(face_members(f)); };
  const auto split = [face_members](const Changes::SplitFace& s) {
    return object(when(s.face != kUnbounded, [&s, face_members] { return face_members(s.face); }),
                  member("into", s.into));
  };
  return members(member("vanished_faces", list(changes.vanished_faces, vanished)),
                 member("split_faces", list(changes.split_faces, split)));
}

void write_rounding(Writer& json, const ExactComplex& exact, const Grid& grid,
                    const Rounding& rounding) {
  const Changes found = changes(exact, rounding);
  const bool is_same = rounding.has_same_incidences();
  const std::vector<Rational> areas = is_same ? std::vector<Rational>() : face_areas(exact);
  json.part(
      member("rounding",
             object(member("grid", to_text(grid)), member("method", name(rounding.method)),
                    member("same_incidences", is_same), member("spacing", rounding.spacing),
                    member("bound", Rational(rounding.spacing / 2)),
                    member("verified", true),  // else there was no Rounding
                    when(grid.decimals,
                         [&] { return member("valid_as_doubles", rounding.valid_as_doubles); }),
                    member("largest_movement", distance(found.largest_squared_movement())),
                    when(!is_same, [&] {
                      return members(member("largest_bend", distance(found.largest_squared_bend())),
                                     vertex_changes(exact, rounding, found),
                                     edge_changes(exact, rounding, found),
                                     face_changes(exact, areas, found));
                    }))));
}

}  // namespace

Part rounding_member(const ExactComplex& exact, const Grid& grid, const Rounding& rounding) {
  return [&exact, grid, &rounding](Writer& json) { write_rounding(json, exact, grid, rounding); };
}

}  // namespace plumbline::json
