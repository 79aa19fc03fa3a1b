// Faces as polygons, in arrays that Shapely and Arrow take; what bounds faces, and what is beside
// them.

#include "plumbline/polygons.hpp"

#include <algorithm>

#include "core.hpp"

namespace plumbline::python {
namespace {

struct Rings {
  std::vector<std::uint32_t> vertices;  ///< closed rings
  std::vector<std::int64_t> ring_starts{0}, polygon_starts{0};
  std::vector<std::uint32_t> faces;

  template <class Ring>
  void add(const Ring& ring) {
    for (const VertexId v : ring) vertices.push_back(static_cast<std::uint32_t>(v));
    vertices.push_back(static_cast<std::uint32_t>(*ring.begin()));
    ring_starts.push_back(static_cast<std::int64_t>(vertices.size()));
  }
};

nb::tuple polygon_rings(const ExactComplex& complex) {
  Rings rings;
  {
    const nb::gil_scoped_release release;
    for (const FacePolygon& polygon : polygons(complex)) {
      rings.add(polygon.outer);
      for (std::size_t h = 0; h < polygon.holes.size(); ++h) rings.add(polygon.holes[h]);
      rings.polygon_starts.push_back(static_cast<std::int64_t>(rings.ring_starts.size() - 1));
      rings.faces.push_back(static_cast<std::uint32_t>(polygon.face));
    }
  }
  return nb::make_tuple(array(std::move(rings.vertices)), array(std::move(rings.ring_starts)),
                        array(std::move(rings.polygon_starts)), array(std::move(rings.faces)));
}

/// Per face its neighbours, and in the same order the lengths of what parts them.
nb::tuple neighbour_arrays(const ExactComplex& complex) {
  Lists<std::uint32_t> faces;
  std::vector<double> lengths;
  {
    const nb::gil_scoped_release release;
    std::vector<std::uint32_t> list;
    for (const std::vector<Neighbour>& next : neighbours(complex)) {
      list.clear();
      for (const Neighbour& neighbour : next) {
        list.push_back(static_cast<std::uint32_t>(neighbour.face));
        lengths.push_back(neighbour.length);
      }
      faces.push_back(list);
    }
  }
  const nb::tuple lists = arrays(std::move(faces));
  return nb::make_tuple(lists[0], lists[1], array(std::move(lengths)));
}

/// Per face the sources of the segments that bound it or end within it, ascending, each once.
nb::tuple face_items(const ExactComplex& complex, const SegmentSet& input) {
  Lists<std::uint32_t> items;
  {
    const nb::gil_scoped_release release;
    std::vector<std::uint32_t> list;
    for (const std::vector<SegmentId>& segments : face_sources(complex)) {
      list.clear();
      for (const SegmentId s : segments) {
        list.push_back(static_cast<std::uint32_t>(input.segment_source.at(s)));
      }
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      items.push_back(list);
    }
  }
  return arrays(std::move(items));
}

nb::object perimeter_array(const ExactComplex& complex) {
  std::vector<double> lengths;
  {
    const nb::gil_scoped_release release;
    lengths = perimeters(complex);
  }
  return array(std::move(lengths));
}

nb::object parents(const ExactComplex& complex) {
  std::vector<std::uint32_t> result(complex.face_count());
  for (std::size_t f = 1; f < result.size(); ++f) {
    result[f] = static_cast<std::uint32_t>(complex.parent(FaceId(f)));
  }
  return array(std::move(result));
}

}  // namespace

void bind_polygons(nb::module_& m) {
  m.def("polygon_rings", &polygon_rings, nb::arg("complex"),
        nb::sig("def polygon_rings(complex: Complex) -> tuple[numpy.typing.NDArray[numpy.uint32], "
                "numpy.typing.NDArray[numpy.int64], numpy.typing.NDArray[numpy.int64], "
                "numpy.typing.NDArray[numpy.uint32]]"),
        "The vertices of closed rings, where rings start in them, where polygons start in rings, "
        "the face of each polygon.");
  m.def("neighbours", &neighbour_arrays, nb::arg("complex"),
        nb::sig("def neighbours(complex: Complex) -> tuple[numpy.typing.NDArray[numpy.uint32], "
                "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.float64]]"));
  m.def("face_items", &face_items, nb::arg("complex"), nb::arg("input"),
        nb::sig("def face_items(complex: Complex, input: SegmentSet) -> "
                "tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.uint32]]"));
  m.def("perimeters", &perimeter_array, nb::arg("complex"),
        nb::sig("def perimeters(complex: Complex) -> numpy.typing.NDArray[numpy.float64]"));
  m.def("face_parents", &parents, nb::arg("complex"),
        nb::sig("def face_parents(complex: Complex) -> numpy.typing.NDArray[numpy.uint32]"),
        "Per face the one that its component lies in; of the unbounded face itself.");
}

}  // namespace plumbline::python
