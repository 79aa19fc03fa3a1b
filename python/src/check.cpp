// Answers held against the exact complex.

#include "plumbline/check.hpp"

#include <utility>

#include "core.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

/// What is asked apart from lines and answer.
struct CheckRequest {
  const Structure* structure = nullptr;  ///< the hierarchy of the lines, if they have one
  bool unit_square = false;              ///< whether the lines are mapped to the unit square
  std::optional<double> tolerance;
  std::optional<bool> right_radii;
  bool ladder = false;
  std::size_t threads = 0;
};

/// Told a part of the work; ends it where that returns false.
void ensure_goes_on(const std::function<bool(double)>& callback, double part) {
  if (!callback(part)) throw Error(ErrorCode::Cancelled, "the check was cancelled");
}

Check checked_as_asked(const SegmentSet& input, const ExactComplex& complex, const Answer& answer,
                       const CheckRequest& request, const std::function<bool(double)>& callback) {
  CheckOptions options;
  options.tolerance = request.tolerance;
  options.threads = request.threads;
  options.begins = [&](const std::string&) { ensure_goes_on(callback, 0); };
  if (request.structure != nullptr) {
    options.parsed = [&] {
      const SegmentSet rounded = evaluate_rounded(*request.structure);
      return request.unit_square ? lar::to_unit_square(rounded) : rounded;
    };
  }
  AdviceOptions advice;
  advice.threads = request.threads;
  advice.progress = callback;
  return with_advice(check(input, complex, answer, options), {request.right_radii, request.ladder},
                     advice);
}

/// The lines with every number rounded to the nearest double: those of Check::doubles_complex.
SegmentSet in_doubles(const SegmentSet& lines) {
  SegmentSet result = lines;
  result.segments = {};
  result.segment_source.clear();
  result.rounding.clear();
  result.rings.clear();
  result.points.clear();
  result.point_source.clear();
  for (std::size_t s = 0; s < lines.segments.size(); ++s) {
    const auto n = lines.segments.numbers(s);
    result.add(nearest(NumberPoint{n[0], n[1]}), nearest(NumberPoint{n[2], n[3]}),
               lines.segment_source[s]);
  }
  for (std::size_t p = 0; p < lines.points.size(); ++p) {
    result.add_point(exact(nearest(lines.points[p])), lines.point_source[p]);
  }
  return result;
}

std::string page(const Check& check) {
  if (check.ladder) return to_html(check);
  AdviceOptions ladder_alone;
  ladder_alone.max_runs = 0;
  return to_html(advised(check, ladder_alone));
}

Table finding_table(const Check& check) {
  return {{{finding_layer(check)}, check.input.crs, "", {}, check.input.unit}};
}

void bind_groups(nb::module_& m) {
  nb::class_<ChangedFaces>(m, "ChangedFaces", "What became of exact faces in an answer.")
      .def_prop_ro(
          "change", [](const ChangedFaces& c) { return to_text(c.change); },
          "\"lost\", \"opened\", \"joined\", \"parted\", \"closed\", \"added\", \"reshaped\".")
      .def_ro("finding", &ChangedFaces::finding, "The number of the finding that says so.")
      .def_ro("areas", &ChangedFaces::areas,
              "Of the exact faces; of closed and added ones the answer's.")
      .def_ro("area", &ChangedFaces::area, "In dispute, 0 where that is not known.");
  nb::class_<FindingGroup>(m, "FindingGroup", "Findings that are one event in one place.")
      .def("__repr__",
           [](const FindingGroup& g) {
             return "<FindingGroup: " + std::to_string(g.findings.size()) + " findings, " +
                    std::to_string(g.faces.size()) + " changed faces>";
           })
      .def_ro("findings", &FindingGroup::findings, "Their numbers, from 1, ascending.")
      .def_ro("lead", &FindingGroup::lead, "The number of the one to look at first.")
      .def_ro("low", &FindingGroup::low, "Lower left corner of the box around the cells.")
      .def_ro("high", &FindingGroup::high, "Upper right corner.")
      .def_ro("faces", &FindingGroup::faces, "What became of faces, the largest first.")
      .def_ro("area", &FindingGroup::area, "In dispute, of all of them.")
      .def_ro("is_own", &FindingGroup::is_own, "Whether the digits of the drawing make it.");
}

void bind_radii(nb::module_& m) {
  nb::class_<TriedRadius>(m, "TriedRadius", "A radius that an engine was run with.")
      .def_ro("radius", &TriedRadius::radius)
      .def_ro("is_right", &TriedRadius::is_right, "Whether its answer agreed.")
      .def_ro("findings", &TriedRadius::findings,
              "How many, the drawing's own left out; None: the numbers of cells were wrong.");
  nb::class_<RightRadii>(m, "RightRadii",
                         "Radii with which an engine's answer is right, as far as they were tried.")
      .def_ro("least", &RightRadii::least, "Every radius tried from here to `largest` is right.")
      .def_ro("largest", &RightRadii::largest)
      .def_ro("tried", &RightRadii::tried, "Ascending.")
      .def_ro("advised", &RightRadii::advised, "One of them for people; None: none is right.")
      .def("__bool__", [](const RightRadii& r) { return !r.empty(); });
}

void bind_outputs(nb::class_<Check>& type) {
  type.def(
          "to_text",
          [](const Check& c, std::optional<std::size_t> listed) { return to_text(c, listed); },
          nb::arg("listed").none(), nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_json", [](const Check& c) { return to_json(c); },
          nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_svg", [](const Check& c) { return to_svg(c); },
          nb::call_guard<nb::gil_scoped_release>())
      .def("to_html", &page, nb::call_guard<nb::gil_scoped_release>())
      .def("table", &finding_table, nb::call_guard<nb::gil_scoped_release>(), "Of the findings.");
}

}  // namespace

void bind_check(nb::module_& m) {
  bind_groups(m);
  bind_radii(m);
  nb::class_<Check> type(m, "Check", "An answer held against the exact complex.");
  type.def("agree", &Check::agree)
      .def("own_findings", &Check::own_findings)
      .def_ro("input", &Check::input)
      .def_ro("exact_complex", &Check::exact_complex)
      .def_ro("answer", &Check::answer)
      .def_ro("comparison", &Check::comparison)
      .def_ro("causes", &Check::causes)
      .def_ro("groups", &Check::groups)
      .def_ro("conversion", &Check::conversion)
      .def_ro("conversion_causes", &Check::conversion_causes)
      .def_ro("crowded_vertices", &Check::crowded_vertices)
      .def_ro("ladder", &Check::ladder)
      .def_ro("right_radii", &Check::right_radii)
      .def("lost", [](const Check& c) { return count_lost(c.input.rejected); });
  bind_outputs(type);
  m.def(
      "check",
      [](const SegmentSet& input, const ExactComplex& complex, const Answer& answer,
         const Structure* structure, bool unit_square, std::optional<double> tolerance,
         std::optional<bool> right_radii, bool ladder, std::size_t threads, nb::object progress) {
        const CheckRequest request{structure, unit_square, tolerance, right_radii, ladder, threads};
        Progress told(std::move(progress));
        return told.run([&](const std::function<bool(double)>& callback) {
          return checked_as_asked(input, complex, answer, request, callback);
        });
      },
      nb::arg("input"), nb::arg("complex"), nb::arg("answer"), nb::arg("structure").none(),
      nb::arg("unit_square"), nb::arg("tolerance").none(), nb::arg("right_radii").none(),
      nb::arg("ladder"), nb::arg("threads"), nb::arg("progress").none());
  m.def(
      "compare_answer",
      [](const ExactComplex& complex, const Answer& answer, double tolerance) {
        if (answer.exact_complex) {
          return compare(complex, *answer.exact_complex, tolerance, answer.compared);
        }
        if (answer.compared == Compared::All) return compare(complex, answer.complex, tolerance);
        return compare(complex, exact(answer.complex), tolerance, answer.compared);
      },
      nb::arg("complex"), nb::arg("answer"), nb::arg("tolerance"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def("in_doubles", &in_doubles, nb::arg("lines"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "choose_some_faces",
      [](Answer& answer) {
        if (answer.compared == Compared::Graph) {
          throw Error(ErrorCode::BadInput, "some faces are those of a result with faces");
        }
        answer.compared = Compared::SomeFaces;
      },
      nb::arg("answer"));
}

}  // namespace plumbline::python
