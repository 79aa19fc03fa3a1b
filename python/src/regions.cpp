// Regions: what expressions select, what polygons cover together, two layers over each other.

#include "plumbline/regions.hpp"

#include <nanobind/stl/tuple.h>

#include <tuple>
#include <utility>

#include "core.hpp"
#include "plumbline/dissolve.hpp"
#include "plumbline/error.hpp"
#include "plumbline/overlay.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

FillRule fill_rule(const std::string& word) {
  for (const FillRule rule :
       {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive, FillRule::Negative}) {
    if (to_text(rule) == word) return rule;
  }
  throw Error(ErrorCode::BadInput, "a fill rule is one of evenodd, nonzero, positive, negative", {},
              word);
}

std::vector<Region> polygon_regions(const SegmentSet& input, const std::string& rule) {
  return regions(input, RegionKind::Polygon, fill_rule(rule));
}

/// Per region the item that it is; that of none for what has no segments.
std::vector<SourceId> items_of(const SegmentSet& input, const std::vector<Region>& regions) {
  std::vector<SourceId> result;
  for (const Region& region : regions) {
    const bool is_empty = region.segments.empty();
    result.push_back(is_empty ? SourceId() : input.segment_source[region.segments.front()]);
  }
  return result;
}

std::vector<RegionPolygons> dissolved(const SegmentSet& input,
                                      const std::vector<std::uint32_t>& groups,
                                      const std::string& rule, std::size_t threads) {
  return dissolve(input, polygon_regions(input, rule), groups, threads);
}

/// What an expression selects, how many regions there are, and the segments of none.
std::tuple<RegionPolygons, std::size_t, std::vector<SegmentId>> selected(
    const SegmentSet& input, const std::string& expression, const std::string& rule,
    std::size_t threads) {
  LayerRegions found = layer_regions(input, fill_rule(rule));
  const std::size_t count = found.regions.size();
  if (count == 0) throw Error(ErrorCode::BadInput, "nothing of the drawing is a polygon or closes");
  ArrangeOptions options;
  options.threads = threads;
  const ExactComplex complex = arrange(input, ExactEngine::Bucket, options);
  const FaceSet faces = select(label(input, complex, std::move(found.regions)), expression);
  return {region_polygons(complex, faces), count, std::move(found.open)};
}

/// Per face the regions that it lies in by evenodd: region r has the segments from start r on.
ListArrays regions_of_faces(const SegmentSet& input, const ExactComplex& complex,
                            const std::vector<std::uint32_t>& starts) {
  std::vector<Region> regions;
  for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
    Region& region = regions.emplace_back();
    for (std::size_t s = starts[r]; s < starts[r + 1]; ++s) region.segments.emplace_back(s);
  }
  return arrays(plumbline::regions_of_faces(label(input, complex, std::move(regions))));
}

/// All pieces as one.
RegionPolygons whole(const Overlay& overlay) {
  FaceSet faces(overlay.complex.face_count());
  for (const Piece& piece : overlay.pieces) {
    for (const FaceId f : piece.faces) faces[f] = true;
  }
  return region_polygons(overlay.complex, faces);
}

Table table(FeatureLayer layer, const Rounding& rounding, const SegmentSet& input) {
  return {{{std::move(layer)}, input.crs, note_of(rounding), input.layers, input.unit}};
}

Table overlay_table(const Overlay& overlay, std::size_t threads) {
  const Rounding rounding = safely_rounded(overlay.complex, {}, {threads, {}});
  return table(piece_layer(overlay, rounding), rounding, overlay.input);
}

Table region_table(const RegionPolygons& polygons, const SegmentSet& input, std::size_t threads) {
  const Rounding rounding = safely_rounded(polygons.complex, {}, {threads, {}});
  return table(region_layer(polygons, rounding), rounding, input);
}

void bind_overlay(nb::module_& m) {
  nb::class_<Piece>(m, "Piece")
      .def_ro("first", &Piece::first, "Polygons of the first layer, among all.")
      .def_ro("second", &Piece::second, "Those of the second one, among all.")
      .def_ro("faces", &Piece::faces)
      .def_ro("area", &Piece::area);
  nb::class_<Overlay>(m, "Overlay", "Two layers of polygons, laid over each other.")
      .def_ro("pieces", &Overlay::pieces)
      .def_ro("first_count", &Overlay::first_count)
      .def_ro("complex", &Overlay::complex)
      .def_ro("open", &Overlay::open)
      .def("items", [](const Overlay& o) { return items_of(o.input, o.regions); })
      .def("whole", &whole, nb::call_guard<nb::gil_scoped_release>(), "All pieces as one.")
      .def("table", &overlay_table, nb::arg("threads"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "overlay",
      [](const SegmentSet& first, const SegmentSet& second, const std::string& how,
         const std::string& rule, std::size_t threads) {
        return overlay(first, second, overlay_how(how), fill_rule(rule), threads);
      },
      nb::arg("first"), nb::arg("second"), nb::arg("how"), nb::arg("rule"), nb::arg("threads"),
      nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace

void bind_regions(nb::module_& m) {
  nb::class_<RegionPolygons>(m, "RegionPolygons", "A set of faces as polygons.")
      .def("__len__", [](const RegionPolygons& r) { return r.polygons.size(); })
      .def_ro("complex", &RegionPolygons::complex)
      .def_ro("areas", &RegionPolygons::areas)
      .def("faces",
           [](const RegionPolygons& r) {
             std::vector<FaceId> faces;
             for (const FacePolygon& polygon : r.polygons) faces.push_back(polygon.face);
             return faces;
           })
      .def("drawing", &drawing_of, nb::call_guard<nb::gil_scoped_release>())
      .def("table", &region_table, nb::arg("input"), nb::arg("threads"),
           nb::call_guard<nb::gil_scoped_release>());
  bind_overlay(m);
  m.def(
      "polygon_items",
      [](const SegmentSet& input) { return items_of(input, polygon_regions(input, "evenodd")); },
      nb::arg("input"), "Per polygon its item.");
  m.def("dissolve", &dissolved, nb::arg("input"), nb::arg("groups"), nb::arg("rule"),
        nb::arg("threads"), nb::call_guard<nb::gil_scoped_release>(),
        "Per group what its polygons cover.");
  m.def("regions_of_faces", &regions_of_faces, nb::arg("input"), nb::arg("complex"),
        nb::arg("starts"));
  m.def("select", &selected, nb::arg("input"), nb::arg("expression"), nb::arg("rule"),
        nb::arg("threads"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
