// The exact arrangement.

#include "plumbline/arrange.hpp"

#include "core.hpp"

namespace plumbline::python {
namespace {

/// Per segment whether it runs as edges do, from the lexicographically lesser end to the other.
nb::object ascending(const SegmentSet& input) {
  std::vector<std::uint8_t> result;
  {
    const nb::gil_scoped_release release;
    result.reserve(input.segments.size());
    for (const Segment& segment : input.segments) result.push_back(segment.a < segment.b ? 1 : 0);
  }
  return array(std::move(result));
}

}  // namespace

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
  m.def("ascending", &ascending, nb::arg("input"),
        nb::sig("def ascending(input: SegmentSet) -> numpy.typing.NDArray[numpy.uint8]"),
        "Per segment 1 where it runs from the lexicographically lesser end to the other, else 0.");
}

}  // namespace plumbline::python
