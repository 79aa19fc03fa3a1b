// Triangles of faces.

#include "plumbline/chains/triangulate.hpp"

#include "core.hpp"

namespace plumbline::python {
namespace {

/// Triangles as rows, and the face of each: of one face, or of all bounded ones.
ListArrays triangles(const ExactComplex& complex, std::optional<std::uint32_t> face) {
  std::vector<std::uint32_t> corners, faces;
  {
    const nb::gil_scoped_release release;
    const std::size_t first = face.value_or(1);
    const std::size_t end = face ? first + 1 : complex.face_count();
    for (std::size_t f = first; f < end; ++f) {
      for (const Triangle& triangle : triangulate(complex, FaceId(f))) {
        for (const VertexId v : triangle) corners.push_back(static_cast<std::uint32_t>(v));
        faces.push_back(static_cast<std::uint32_t>(f));
      }
    }
  }
  return nb::borrow<ListArrays>(
      nb::make_tuple(array(std::move(corners), 3), array(std::move(faces))));
}

}  // namespace

void bind_triangulate(nb::module_& m) {
  m.def("triangulate", &triangles, nb::arg("complex"), nb::arg("face").none());
}

}  // namespace plumbline::python
