// Programs that are engines.

#include "plumbline/engines/programs.hpp"

#include <nanobind/stl/pair.h>

#include <filesystem>
#include <utility>

#include "core.hpp"

namespace plumbline::python {
namespace {

using programs::Configuration;
using programs::Listing;

std::vector<std::pair<std::string, std::string>> programs_in(
    const std::vector<std::string>& folders) {
  const std::vector<std::filesystem::path> paths(folders.begin(), folders.end());
  std::vector<std::pair<std::string, std::string>> result;
  for (const programs::Program& program : programs::found_in(paths)) {
    result.emplace_back(program.name, program.path.string());
  }
  return result;
}

}  // namespace

void bind_programs(nb::module_& m) {
  nb::class_<Configuration>(m, "EngineConfiguration", "One way to call an engine.")
      .def("__repr__",
           [](const Configuration& c) {
             return "<EngineConfiguration " + line_text(c.name) + ": " + line_text(c.title) + ">";
           })
      .def_ro("name", &Configuration::name)
      .def_ro("title", &Configuration::title)
      .def_prop_ro(
          "tolerance_kind", [](const Configuration& c) { return to_text(c.tolerance_kind); },
          "\"none\"; \"grid\", which vertices are on; \"snap\": nearer vertices are one; "
          "\"relative\": a grid of so much of the drawing's longer side.")
      .def_ro("tolerance", &Configuration::tolerance, "In drawing units; 0 of none.")
      .def_ro("source", &Configuration::source, "Where the engine's documentation has this way.");
  nb::class_<Listing>(m, "EngineListing", "What a program says of its engine.")
      .def_ro("engine", &Listing::engine)
      .def_ro("title", &Listing::title)
      .def_ro("version", &Listing::version)
      .def_ro("algorithm", &Listing::algorithm)
      .def_ro("licence", &Listing::licence)
      .def_ro("takes_rings", &Listing::takes_rings, "And no line work: not for `cross_check`.")
      .def_ro("configurations", &Listing::configurations);
  m.def("programs_in", &programs_in, nb::arg("folders"));
  m.def(
      "program_listing", [](const std::string& path) { return programs::listing(path); },
      nb::arg("path"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
