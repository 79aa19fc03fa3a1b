// What a repair is: edits, what was refused, what became of faces, what changed on the whole.

#include "plumbline/edits.hpp"

#include <nanobind/stl/pair.h>

#include <string>
#include <utility>

#include "core.hpp"
#include "plumbline/output.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

using Ends = std::pair<Point, Point>;

std::vector<Ends> ends_of(const std::vector<Segment>& segments) {
  std::vector<Ends> result;
  for (const Segment& segment : segments) result.emplace_back(segment.a, segment.b);
  return result;
}

/// "<Edit: grow by 0.02 at (10, 0.02)>".
std::string described(const char* name, const std::string& what) {
  std::string text(1, '<');
  return text.append(name).append(": ").append(what).append(1, '>');
}

/// Members that edits and refusals have in common.
template <class T>
nb::class_<T> bind_sized(nb::module_& m, const char* name, const char* doc) {
  nb::class_<T> type(m, name, doc);
  type.def_prop_ro(
          "kind", [](const T& edit) { return to_text(edit.kind); },
          "merge, dissolve, grow, bridge, joint, door, trim, sliver, weld, snap or simplify.")
      .def_ro("where", &T::where, "Where to look.")
      .def_prop_ro(
          "size", [](const T& edit) { return nearest_sqrt(edit.squared_size); },
          "How far it goes, correctly rounded.")
      .def_ro("squared_size", &T::squared_size, "The square of that, exactly.")
      .def("__repr__", [name](const T& edit) {
        const double size = nearest_sqrt(edit.squared_size);
        return described(
            name, to_text(edit.kind) + " by " + shortest_text(size) + " at " + to_text(edit.where));
      });
  return type;
}

void bind_edit_types(nb::module_& m) {
  nb::class_<Line>(m, "Line", "A line of a drawing under repair.")
      .def_ro("a", &Line::a)
      .def_ro("b", &Line::b)
      .def_ro("segments", &Line::segments,
              "Of the input, for which it stands, ascending; none: a virtual line.");
  bind_sized<Edit>(m, "Edit", "One edit: lines gave way to others.")
      .def_ro("before", &Edit::before, "Lines that are no longer there.")
      .def_ro("after", &Edit::after, "Lines that are there instead.");
  bind_sized<Refusal>(m, "Refusal", "What would have been an edit, and why it is none.")
      .def_ro("reason", &Refusal::reason)
      .def_ro("segments", &Refusal::segments, "Of the input, ascending.");
  nb::class_<Tolerances> tolerances(
      m, "Tolerances", "Up to which size each operation repairs; 0, or None: it does not.");
  tolerances.def_ro("weld", &Tolerances::weld)
      .def_ro("grow", &Tolerances::grow)
      .def_ro("trim", &Tolerances::trim)
      .def_ro("sliver", &Tolerances::sliver)
      .def_ro("snap", &Tolerances::snap)
      .def_ro("simplify", &Tolerances::simplify)
      .def_prop_ro(
          "doors",
          [](const Tolerances& t) -> std::optional<std::pair<Rational, Rational>> {
            if (!t.doors) return std::nullopt;
            return std::pair{t.doors->least, t.doors->most};
          },
          "Least and largest width.")
      .def("__str__", [](const Tolerances& t) { return to_text(t); })
      .def("__repr__", [](const Tolerances& t) { return described("Tolerances", to_text(t)); });
  define_equality(tolerances);
}

void bind_outcome_types(nb::module_& m) {
  nb::class_<FaceOutcome>(m, "FaceOutcome", "What became of a face.")
      .def_prop_ro(
          "fate", [](const FaceOutcome& f) { return to_text(f.fate); },
          "closed, split, joined, opened or changed.")
      .def_prop_ro(
          "before", [](const FaceOutcome& f) { return std::size_t{f.before}; },
          "The face in the arrangement of the input.")
      .def_prop_ro(
          "after", [](const FaceOutcome& f) { return std::size_t{f.after}; },
          "The face in that of the output.")
      .def_ro("area_before", &FaceOutcome::area_before, "Exact; 0 of the unbounded face.")
      .def_ro("area_after", &FaceOutcome::area_after, "Exact; 0 of the unbounded face.")
      .def_ro("where", &FaceOutcome::where, "A point inside.")
      .def_ro("edits", &FaceOutcome::edits, "Those that did it, ascending.")
      .def("__repr__", [](const FaceOutcome& f) {
        return described("FaceOutcome", to_text(f.fate) + ", area " + exact_text(f.area_before) +
                                            " -> " + exact_text(f.area_after));
      });
  nb::class_<Breach>(m, "Breach", "A promise of a repair that is not kept.")
      .def_ro("message", &Breach::message, "One sentence, with numbers.")
      .def_ro("where", &Breach::where)
      .def_ro("edit", &Breach::edit, "Index, if it is that of one edit.")
      .def("__repr__", [](const Breach& b) { return described("Breach", b.message); });
  nb::class_<SourcedSegment>(m, "SourcedSegment", "A segment of the input, and where it is from.")
      .def_prop_ro("ends", [](const SourcedSegment& s) { return Ends(s.segment.a, s.segment.b); })
      .def_ro("source", &SourcedSegment::source)
      .def_ro("file", &SourcedSegment::file, "The file's name.");
  nb::class_<NetChange>(m, "NetChange", "Segments of the input, and what they became together.")
      .def_ro("before", &NetChange::before, "In the input's order; none: virtual lines were added.")
      .def_prop_ro(
          "after", [](const NetChange& c) { return ends_of(c.after); },
          "Ends of segments of the output; none: they went.");
}

Table line_table(const SegmentSet& lines) {
  return {{{line_layer(lines)}, lines.crs, "nearest doubles", lines.layers, lines.unit}};
}
Table edit_table(const Repair& repair, const SegmentSet& input) {
  return {{{edit_layer(repair, input)}, input.crs, "", {}, input.unit}};
}

using Type = nb::class_<Repair>;

void bind_writing(Type& type) {
  type.def("line", &repair_line, "\"7 edits: 3 ends grown by up to 0.02, ...\".")
      .def(
          "to_text",
          [](const Repair& repair, const SegmentSet& input, std::optional<std::size_t> listed) {
            return to_text(repair, input, listed);
          },
          nb::arg("input"), nb::arg("listed").none())
      .def(
          "to_json",
          [](const Repair& repair, const SegmentSet& input) { return to_json(repair, input); },
          nb::arg("input"), nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_svg",
          [](const Repair& repair, const SegmentSet& input, const ExactComplex& before,
             const ExactComplex& after) { return to_svg(repair, input, before, after); },
          nb::arg("input"), nb::arg("before"), nb::arg("after"),
          nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_html",
          [](const Repair& repair, const SegmentSet& input, const ExactComplex& before,
             const ExactComplex& after) { return to_html(repair, input, before, after); },
          nb::arg("input"), nb::arg("before"), nb::arg("after"),
          nb::call_guard<nb::gil_scoped_release>())
      .def("table", &edit_table, nb::arg("input"), nb::call_guard<nb::gil_scoped_release>(),
           "Edits, and what was refused, as points.");
}

}  // namespace

void bind_edits(nb::module_& m) {
  bind_edit_types(m);
  bind_outcome_types(m);
  Type type(m, "Repair", "A repaired drawing, and what was done to it.");
  type.def_ro("output", &Repair::output)
      .def("origins",
           [](nb::handle self) { return view(nb::cast<const Repair&>(self).origins, self); })
      .def_ro("edits", &Repair::edits)
      .def_ro("refused", &Repair::refused)
      .def_ro("faces", &Repair::faces)
      .def_ro("anchored", &Repair::anchored)
      .def_ro("tolerances", &Repair::tolerances)
      .def_ro("reasons", &Repair::reasons);
  bind_writing(type);
  m.def(
      "verify_repair",
      [](const SegmentSet& input, const ExactComplex& before, const Repair& repair,
         const ExactComplex& after) { return verify(input, before, repair, after); },
      nb::arg("input"), nb::arg("before"), nb::arg("repair"), nb::arg("after"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def("net_changes", &net_changes, nb::arg("input"), nb::arg("repair"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("rounded_signature", &rounded_signature, nb::arg("drawing"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("line_table", &line_table, nb::arg("lines"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
