// Repairing, undoing, and the file of a drawing that was repaired.

#include "plumbline/repair.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string_view.h>

#include <optional>
#include <string>
#include <utility>

#include "core.hpp"
#include "plumbline/detail/new_file.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::python {
namespace {

using Widths = std::pair<Rational, Rational>;

void bind_options(nb::module_& m) {
  nb::class_<RepairOptions>(m, "RepairOptions", "How to repair.")
      .def(nb::init<>())
      .def_rw("weld", &RepairOptions::weld)
      .def_rw("grow", &RepairOptions::grow)
      .def_rw("trim", &RepairOptions::trim)
      .def_rw("sliver", &RepairOptions::sliver)
      .def_rw("snap", &RepairOptions::snap)
      .def_rw("simplify", &RepairOptions::simplify)
      .def_prop_rw(
          "doors",
          [](const RepairOptions& o) -> std::optional<Widths> {
            if (!o.doors) return std::nullopt;
            return Widths(o.doors->least, o.doors->most);
          },
          [](RepairOptions& o, const std::optional<Widths>& widths) {
            o.doors.reset();
            if (widths) o.doors = Range{widths->first, widths->second};
          },
          nb::for_setter(nb::arg("widths").none()))
      .def_rw("keeps_common_sides", &RepairOptions::keeps_common_sides)
      .def_rw("keeps_layers", &RepairOptions::keeps_layers)
      .def_rw("walls", &RepairOptions::walls)
      .def_rw("anchors", &RepairOptions::anchors)
      .def_rw("excepted", &RepairOptions::except);
}

/// The log that `to_json` would write, without the detour.
RepairLog log_of(const SegmentSet& input, const Repair& repair) {
  return {net_changes(input, repair), rounded_signature(input), rounded_signature(repair.output)};
}

void bind_log(nb::module_& m) {
  nb::class_<RepairLog>(m, "RepairLog", "What a repair changed, and of which drawing.")
      .def_ro("changes", &RepairLog::changes)
      .def_ro("input_signature", &RepairLog::input_signature)
      .def_ro("output_signature", &RepairLog::output_signature);
  m.def("read_repair_log", &read_repair_log, nb::arg("file"),
        nb::sig("def read_repair_log(file: str) -> RepairLog"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("repair_log", &log_of, nb::arg("input"), nb::arg("repair"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "undo", [](const SegmentSet& output, const RepairLog& log) { return undo(output, log); },
      nb::arg("output"), nb::arg("log"), nb::call_guard<nb::gil_scoped_release>());
}

void bind_files(nb::module_& m) {
  nb::class_<PatchedFile>(m, "PatchedFile", "The text of a drawing's file with changes.")
      .def_prop_ro(
          "text", [](const PatchedFile& p) { return nb::bytes(p.text.data(), p.text.size()); },
          "In the file's own encoding.")
      .def_ro("replaced", &PatchedFile::replaced, "Elements that gave way to lines.")
      .def_ro("why_not", &PatchedFile::why_not, "\"\" where it is done.");
  using OfSegments = PatchedFile(const std::filesystem::path&, std::string_view, const ReadOptions&,
                                 const SegmentSet&, const SegmentSet&);
  m.def("patched_file", static_cast<OfSegments*>(&patched_file), nb::arg("file"), nb::arg("format"),
        nb::arg("options"), nb::arg("input"), nb::arg("output"),
        nb::sig("def patched_file(file: str, format: str, options: ReadOptions, input: SegmentSet, "
                "output: SegmentSet) -> PatchedFile"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "exact_lines", [](const SegmentSet& set) { return to_lines(set); }, nb::arg("lines"),
      nb::call_guard<nb::gil_scoped_release>(), "As a .lines file.");
  m.def(
      "picture_of_lines", [](const SegmentSet& set) { return to_svg(set); }, nb::arg("lines"),
      nb::call_guard<nb::gil_scoped_release>(), "As SVG.");
}

}  // namespace

void bind_repair(nb::module_& m) {
  bind_options(m);
  bind_log(m);
  bind_files(m);
  m.def(
      "repair",
      [](const SegmentSet& input, RepairOptions options) {
        Progress signals{nb::none()};
        return signals.run([&](const std::function<bool(double)>& told) {
          options.goes_on = [&] { return told(0); };
          return repair(input, options);
        });
      },
      nb::arg("input"), nb::arg("options"));
  nb::class_<RuleOutcome>(m, "RuleOutcome", "What a rule makes of a drawing.")
      .def_ro("rule", &RuleOutcome::rule)
      .def_ro("vertices", &RuleOutcome::vertices)
      .def_ro("edges", &RuleOutcome::edges)
      .def_ro("faces", &RuleOutcome::faces, "Bounded ones.")
      .def_ro("area", &RuleOutcome::area, "Of the faces, rounded.")
      .def_ro("skewed", &RuleOutcome::skewed,
              "Edges that are nearly, but not, parallel to an axis.")
      .def_ro("moved", &RuleOutcome::moved, "Vertices where the drawing has none.")
      .def_ro("furthest", &RuleOutcome::furthest,
              "Of those from the nearest vertex that was there, rounded.")
      .def("__repr__", [](const RuleOutcome& r) {
        return std::string("<RuleOutcome: ")
            .append(r.rule)
            .append(", ")
            .append(std::to_string(r.faces))
            .append(" faces>");
      });
  m.def("compare_rules", &compare_rules, nb::arg("input"), nb::arg("repair"), nb::arg("tolerance"),
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
