// The complex as short arrays: what it takes to have it again, and nothing that follows from that.

#include "output/json/input.hpp"
#include "output/json/signed_edges.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

/// [tail, head, segment...]
auto edge_row(const ExactComplex& c, EdgeId e) {
  const auto segments = c.edge_sources[e];
  return list(2 + segments.size(), [edge = c.edges[e], segments](std::size_t i) -> std::size_t {
    return i == 0 ? edge.tail : (i == 1 ? edge.head : segments[i - 2]);
  });
}

/// [outer cycle or null, hole...]
auto face_row(const ExactComplex& c, FaceId f) {
  const auto holes = c.face_holes[f];
  return list(1 + holes.size(), [&c, f, holes](std::size_t i) {
    const CycleId cycle = i == 0 ? c.face_outer[f] : holes[i - 1];
    return given(cycle.valid(), [&] { return signed_edges(c.cycles[cycle]); });
  });
}

/// [face, vertex] of every isolated vertex.
std::vector<std::array<std::size_t, 2>> isolated_rows(const ExactComplex& c) {
  std::vector<std::array<std::size_t, 2>> rows;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    for (const VertexId v : c.face_isolated_vertices[f]) rows.push_back({f, v});
  }
  return rows;
}

}  // namespace
}  // namespace json

std::string to_compact_json(const ExactComplex& complex, const SegmentSet& input) {
  using namespace json;
  return document(
      object(member("format", "plumbline compact arrangement 1"),
             member("signature", signature(complex)), member("exact", input.ledger.empty()),
             member("vertices", list(complex.vertices.size(),
                                     [&](std::size_t v) {
                                       return Stored{complex.vertices, v};
                                     })),
             member("edges", list(complex.edge_count(),
                                  [&](std::size_t e) { return edge_row(complex, EdgeId(e)); })),
             member("faces", list(complex.face_count(),
                                  [&](std::size_t f) { return face_row(complex, FaceId(f)); })),
             member("isolated_vertices", isolated_rows(complex)), crs_member(input.crs),
             member("files", input.files), losses(input.rejected, input.remarks, input.ledger)),
      Layout::Dense);
}

}  // namespace plumbline
