// Hierarchies of Structs, and what they come to.

#include "plumbline/structure.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_structure(nb::module_& m) {
  nb::class_<Structure>(m, "Structure", "A hierarchy of Structs, each stored once.")
      .def_ro("files", &Structure::files)
      .def_ro("rejected", &Structure::rejected)
      .def_ro("remarks", &Structure::remarks)
      .def_ro("ledger", &Structure::ledger)
      .def(
          "evaluate",
          [](const Structure& s, bool doubles) {
            return doubles ? evaluate_rounded(s) : evaluate(s);
          },
          nb::arg("doubles"), nb::call_guard<nb::gil_scoped_release>(),
          "Its segments; with `doubles` of what its numbers are as nearest doubles.");
}

}  // namespace plumbline::python
