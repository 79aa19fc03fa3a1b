// Coverages: what is wrong with them, and faces given to other polygons.

#include "plumbline/coverage.hpp"

#include <utility>

#include "core.hpp"
#include "plumbline/features.hpp"
#include "plumbline/round.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

/// Per polygon its item.
std::vector<SourceId> items_of(const Coverage& coverage, const SegmentSet& input) {
  std::vector<SourceId> result;
  for (const Region& polygon : coverage.polygons) {
    result.push_back(input.segment_source[polygon.segments.front()]);
  }
  return result;
}

/// Per polygon the faces of its parts, as `polygon_rings` of the complex has them where no polygons
/// overlap.
std::vector<std::vector<FaceId>> faces_of(const Coverage& coverage) {
  std::vector<std::vector<FaceId>> result(coverage.polygons.size());
  for (std::size_t f = 0; f < coverage.owners.size(); ++f) {
    for (const RegionId r : coverage.owners[f]) result[r].emplace_back(f);
  }
  return result;
}

Table table_of(const Coverage& coverage, const SegmentSet& input, std::size_t threads) {
  const Rounding rounding = safely_rounded(coverage.complex, {}, {threads, {}});
  return {{{polygon_layer(drawn_polygons(coverage, input, rounding), input.files)},
           input.crs,
           note_of(rounding),
           input.layers,
           input.unit}};
}

CleanCoverage clean(const Coverage& coverage, const SegmentSet& input,
                    const std::vector<CoverageFault>& faults, const std::string& policy,
                    std::optional<Rational> width, std::optional<Rational> area) {
  CleanOptions options;
  options.policy = coverage_policy(policy);
  options.gaps = options.overlaps = {std::move(width), std::move(area)};
  return cleaned(coverage, input, faults, options);
}

}  // namespace

void bind_coverage(nb::module_& m) {
  nb::class_<CoverageFault>(m, "CoverageFault")
      .def_prop_ro("kind", [](const CoverageFault& f) { return to_text(f.kind); })
      .def_ro("polygons", &CoverageFault::polygons)
      .def_ro("at", &CoverageFault::at)
      .def_ro("area", &CoverageFault::area)
      .def_ro("width", &CoverageFault::width);
  nb::class_<Coverage>(m, "Coverage", "Polygons, and which of them lie where.")
      .def_ro("complex", &Coverage::complex)
      .def("areas", &polygon_areas)
      .def("items", &items_of, nb::arg("input"), "Per polygon its item.")
      .def("faces", &faces_of, "Per polygon its faces.")
      .def("table", &table_of, nb::arg("input"), nb::arg("threads"),
           nb::call_guard<nb::gil_scoped_release>())
      .def("faults", &faults, nb::arg("input"), nb::call_guard<nb::gil_scoped_release>());
  nb::class_<Reassigned>(m, "Reassigned")
      .def_ro("fault", &Reassigned::fault)
      .def_ro("to", &Reassigned::to);
  nb::class_<CleanCoverage>(m, "CleanCoverage")
      .def_ro("coverage", &CleanCoverage::coverage)
      .def_ro("changes", &CleanCoverage::changes)
      .def_ro("vanished", &CleanCoverage::vanished);
  m.def(
      "coverage",
      [](const SegmentSet& input, const ExactComplex& complex) { return coverage(input, complex); },
      nb::arg("input"), nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>());
  m.def("clean", &clean, nb::arg("coverage"), nb::arg("input"), nb::arg("faults"),
        nb::arg("policy"), nb::arg("width").none(), nb::arg("area").none(),
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
