// Certificates of arrangements, and the checker, which shares nothing with what makes them.

#include "checker/verify.hpp"
#include "core.hpp"
#include "plumbline/output.hpp"

namespace plumbline::python {
namespace {

using plumbline_checker::Outcome;
using plumbline_checker::Verdict;
using CheckedCounts = plumbline_checker::Counts;

nb::bytes certificate_of(const ExactComplex& complex, const SegmentSet& input) {
  std::string text;
  {
    const nb::gil_scoped_release release;
    text = certificate(complex, input);
  }
  return nb::bytes(text.data(), text.size());
}

Verdict verdict_on(const SegmentSet& input, const nb::bytes& certificate) {
  const std::string_view text(certificate.c_str(), certificate.size());
  const nb::gil_scoped_release release;
  return plumbline_checker::verify(to_lines(input), text);
}

}  // namespace

void bind_certificate(nb::module_& m) {
  nb::class_<CheckedCounts>(m, "CheckedCounts", "What a certificate was proved of, in numbers.")
      .def_ro("segments", &CheckedCounts::segments)
      .def_ro("points", &CheckedCounts::points)
      .def_ro("without_length", &CheckedCounts::without_length)
      .def_ro("vertices", &CheckedCounts::vertices)
      .def_ro("edges", &CheckedCounts::edges)
      .def_ro("cycles", &CheckedCounts::cycles)
      .def_ro("faces", &CheckedCounts::faces, "With the unbounded one.")
      .def_ro("components", &CheckedCounts::components)
      .def_ro("isolated_vertices", &CheckedCounts::isolated_vertices)
      .def_ro("pieces", &CheckedCounts::pieces, "Pairs of an edge and a segment that covers it.");
  nb::class_<Verdict>(m, "Verdict", "Whether a certificate proves the arrangement of lines.")
      .def_prop_ro("proved", [](const Verdict& v) { return v.outcome == Outcome::Proved; })
      .def_prop_ro("is_bad_input", [](const Verdict& v) { return v.outcome == Outcome::BadInput; })
      .def_ro("counts", &Verdict::counts, "If proved.")
      .def_ro("reason", &Verdict::reason, "What is wrong first, in a sentence; \"\" if proved.")
      .def_ro("line", &Verdict::line, "Of the certificate, from 1; 0: none.")
      .def_ro("place", &Verdict::place,
              "The exact point \"(1/2, 1/3)\" where it is wrong, or \"\".")
      .def_prop_ro(
          "report", [](const Verdict& v) { return plumbline_checker::report(v); },
          "What was proved, or what is wrong where, in plain English.")
      .def("__bool__", [](const Verdict& v) { return v.outcome == Outcome::Proved; })
      .def("__str__", [](const Verdict& v) { return plumbline_checker::report(v); })
      .def("__repr__", [](const Verdict& v) {
        return v.outcome == Outcome::Proved ? std::string("<Verdict: proved>")
                                            : "<Verdict: refused: " + v.reason + ">";
      });
  m.def("certificate", &certificate_of, nb::arg("complex"), nb::arg("input"));
  m.def("verify", &verdict_on, nb::arg("input"), nb::arg("certificate"));
}

}  // namespace plumbline::python
