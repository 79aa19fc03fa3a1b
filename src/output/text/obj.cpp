// Wavefront OBJ: vertices, edges as lines, faces as triangles.

#include "plumbline/chains/triangulate.hpp"
#include "plumbline/output.hpp"

namespace plumbline {

std::string to_obj(const Rounding& rounding) {
  const ExactComplex& complex = rounding.complex;
  std::string text = "# " + note_of(rounding) + "\n";
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const PointD p = complex.vertices.nearest(v);
    ((((text += "v ") += shortest_text(p.x)) += ' ') += shortest_text(p.y)) += " 0\n";
  }
  const auto add = [&text](const char* what, std::span<const VertexId> vertices) {
    text += what;
    for (const VertexId v : vertices) (text += ' ') += std::to_string(std::size_t{v} + 1);
    text += '\n';
  };
  if (complex.edge_count() > 0) text += "g edges\n";
  for (const auto& [tail, head] : complex.edges) add("l", std::array{tail, head});
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    ((text += "g face_") += std::to_string(f)) += '\n';
    for (const Triangle& triangle : triangulate(complex, FaceId(f))) add("f", triangle);
  }
  return text;
}

}  // namespace plumbline
