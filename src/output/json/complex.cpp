#include "output/json/input.hpp"
#include "output/json/rounding.hpp"
#include "output/json/signed_edges.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

/// What else is written of a complex whose coordinates are rounded.
struct Rounded {
  const ExactComplex& exact;
  const Grid& grid;
  const Rounding& rounding;
};

/// The numbers beside the exact coordinates of vertex v of the written complex.
std::array<std::variant<double, Digits>, 2> numbers(const PointList& points, VertexId v,
                                                    const Rounded* rounded) {
  const bool is_moved = rounded != nullptr && rounded->rounding.has_same_incidences();
  const PointList& to = is_moved ? rounded->rounding.complex.vertices : points;
  const VertexId w = is_moved ? rounded->rounding.vertex_image[v] : v;
  if (rounded != nullptr && rounded->grid.decimals) {
    const Point p = to[w];
    return {Digits{decimal_text(p.x)}, Digits{decimal_text(p.y)}};
  }
  const PointD p = to.nearest(w);
  return {p.x, p.y};
}

auto edge(const ExactComplex& c, EdgeId e) {
  return object(member("tail", c.edges[e].tail), member("head", c.edges[e].head),
                member("antenna", c.is_antenna(e)), member("segments", c.edge_sources[e]));
}

auto face(const ExactComplex& c, FaceId f, const Rational& area) {
  const auto cycle = [&c](CycleId id) { return signed_edges(c.cycles[id]); };
  return object(
      member("outer", given(c.face_outer[f].valid(), [&] { return cycle(c.face_outer[f]); })),
      member("holes", list(c.face_holes[f], cycle)),
      member("isolated_vertices", c.face_isolated_vertices[f]), member("depth", c.face_depth[f]),
      when(f != kUnbounded, [&c, f, &area] {
        return members(member("parent", c.parent(f)), member("area", area),
                       member("interior_point", interior_point(c, f)));
      }));
}

auto cells(const ExactComplex& c, const std::vector<Rational>& areas, const Rounded* rounded) {
  const auto vertex = [&c, rounded](std::size_t v) {
    return object(member("exact", Stored{c.vertices, v}),
                  member("nearest", numbers(c.vertices, VertexId(v), rounded)));
  };
  const auto component = [](FaceId parent) { return object(member("parent", parent)); };
  return members(
      member("vertices", list(c.vertices.size(), vertex)),
      member("edges", list(c.edge_count(), [&c](std::size_t e) { return edge(c, EdgeId(e)); })),
      member("faces", list(c.face_count(),
                           [&c, &areas](std::size_t f) { return face(c, FaceId(f), areas[f]); })),
      member("components", list(c.component_parent, component)));
}

std::string text(const ExactComplex& complex, const SegmentSet& input, const Rounded* rounded) {
  const bool is_exact =
      input.ledger.empty() && (rounded == nullptr || rounded->rounding.has_same_incidences());
  const std::vector<Rational> areas = face_areas(complex);
  return document(object(
      member("format", "plumbline arrangement 1"), member("signature", signature(complex)),
      member("exact", is_exact),
      when(rounded,
           [rounded] { return rounding_member(rounded->exact, rounded->grid, rounded->rounding); }),
      cells(complex, areas, rounded), input_members(input)));
}

}  // namespace
}  // namespace json

std::string to_json(const ExactComplex& complex, const SegmentSet& input) {
  return json::text(complex, input, nullptr);
}

std::string to_json(const ExactComplex& complex, const SegmentSet& input, const Grid& grid,
                    const Rounding& rounding) {
  const json::Rounded rounded{complex, grid, rounding};
  return json::text(rounding.has_same_incidences() ? complex : rounding.complex, input, &rounded);
}

}  // namespace plumbline
