// Faces as polygons, in arrays that Shapely and Arrow take; what bounds faces, and what is beside
// them.

#include "plumbline/polygons.hpp"

#include <algorithm>

#include "core.hpp"

namespace plumbline::python {
namespace {

using RingArrays = nb::typed<nb::tuple, IndexArray, IntArray, IntArray, IndexArray>;
using NeighbourArrays = nb::typed<nb::tuple, IndexArray, IndexArray, DoubleArray>;

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

RingArrays polygon_rings(const ExactComplex& complex) {
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
  return nb::borrow<RingArrays>(
      nb::make_tuple(array(std::move(rings.vertices)), array(std::move(rings.ring_starts)),
                     array(std::move(rings.polygon_starts)), array(std::move(rings.faces))));
}

/// Per face its neighbours, and in the same order the lengths of what parts them.
NeighbourArrays neighbour_arrays(const ExactComplex& complex) {
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
  const ListArrays lists = arrays(std::move(faces));
  return nb::borrow<NeighbourArrays>(nb::make_tuple(lists[0], lists[1], array(std::move(lengths))));
}

/// Per face the sources of the segments that bound it or end within it, ascending, each once.
ListArrays face_items(const ExactComplex& complex, const SegmentSet& input) {
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

DoubleArray perimeter_array(const ExactComplex& complex) {
  std::vector<double> lengths;
  {
    const nb::gil_scoped_release release;
    lengths = perimeters(complex);
  }
  return array(std::move(lengths));
}

IndexArray parents(const ExactComplex& complex) {
  std::vector<std::uint32_t> result(complex.face_count());
  for (std::size_t f = 1; f < result.size(); ++f) {
    result[f] = static_cast<std::uint32_t>(complex.parent(FaceId(f)));
  }
  return array(std::move(result));
}

}  // namespace

void bind_polygons(nb::module_& m) {
  m.def("polygon_rings", &polygon_rings, nb::arg("complex"),
        "The vertices of closed rings, where rings start in them, where polygons start in rings, "
        "the face of each polygon.");
  m.def("neighbours", &neighbour_arrays, nb::arg("complex"));
  m.def("face_items", &face_items, nb::arg("complex"), nb::arg("input"));
  m.def("perimeters", &perimeter_array, nb::arg("complex"));
  m.def("face_parents", &parents, nb::arg("complex"),
        "Per face the one that its component lies in; of the unbounded face itself.");
}

}  // namespace plumbline::python
