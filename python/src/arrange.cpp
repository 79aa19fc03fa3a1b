// The exact arrangement.

#include "plumbline/arrange.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_arrange(nb::module_& m) {
  m.def(
      "arrange",
      [](const SegmentSet& input, bool reference, std::size_t threads, nb::object progress) {
        Progress told(std::move(progress));
        return told.run([&](const std::function<bool(double)>& callback) {
          return arrange(input, reference ? ExactEngine::Cgal : ExactEngine::Bucket,
                         {.threads = threads, .progress = callback});
        });
      },
      nb::arg("input"), nb::arg("reference"), nb::arg("threads"), nb::arg("progress").none());
}

}  // namespace plumbline::python
