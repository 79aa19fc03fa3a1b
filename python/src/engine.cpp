// Engines, and answers: what they, or other programs, make of drawings.

#include "plumbline/engine.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "core.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::python {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

bool is_preset(const std::string& text) {
  return std::find(kRadiusPresets.begin(), kRadiusPresets.end(), text) != kRadiusPresets.end();
}

/// Names with texts as parameters of the engine; presets of the radius as that of the input.
/// `radius_from` says where the radius comes from.
Parameters parameters_of(const Engine& engine, const Settings& settings, const SegmentSet& input,
                         std::string& radius_from) {
  Parameters parameters;
  for (const auto& [name, text] : settings) {
    if (name != "radius" || !is_preset(text)) {
      parameters[name] = parameter_value(engine, name, text);
      if (name == "radius") radius_from = "number";
      continue;
    }
    parameter_value(engine, name, "0");  // refused where the engine has no radius
    radius_from = text;
    if (const auto radius = preset_radius(text, input)) parameters[name] = *radius;
  }
  return parameters;
}

using Folders = std::vector<std::string>;

/// Of the library, or a program in one of the folders, or at a path.
Engine engine_of(const std::string& name, const Folders& folders) {
  const std::vector<std::filesystem::path> paths(folders.begin(), folders.end());
  return engine_named(name, engines(), paths);
}

/// The engine as it runs on this drawing: of inters what it is told apart from the segments.
Engine engine_on(Engine engine, const std::string& name, const SegmentSet& drawing,
                 bool unit_square, const std::string& svg_file, const Parameters& parameters) {
  if (!svg_file.empty()) {
    plumbline::Drawing as_read;
    as_read.file = svg_file;
    as_read.unit_square = unit_square;
    return inters_with_svg2lines(as_read);
  }
  if (name != "inters" || !unit_square) return engine;
  const auto decimals = parameters.find("decimals");
  inters::Original original;
  original.lines = inters::lines_on_unit_square(
      drawing, decimals == parameters.end()
                   ? inters::kDecimals
                   : static_cast<int>(std::get<std::int64_t>(decimals->second)));
  return inters::engine(std::move(original));
}

Answer engine_answer(const std::string& name, const SegmentSet& drawing, bool unit_square,
                     const Settings& settings, const std::string& svg_file, const Folders& folders,
                     std::size_t threads) {
  const SegmentSet mapped = unit_square ? lar::to_unit_square(drawing) : SegmentSet();
  const SegmentSet& input = unit_square ? mapped : drawing;
  std::string radius_from = "drawing";
  const Engine engine = engine_of(name, folders);
  const Parameters parameters = parameters_of(engine, settings, input, radius_from);
  Answer answer = answer_of(engine_on(engine, name, drawing, unit_square, svg_file, parameters),
                            input, parameters, threads);
  const bool has_reason = radius_from == "drawing" && !answer.radius_from.empty();
  if (answer.radius && !has_reason) answer.radius_from = radius_from;
  return answer;
}

files::Result read_result_text(const std::string& format, const std::string& text,
                               const std::string& name) {
  if (format == "geojson") return files::read_geojson(text, name);
  if (format == "wkt") return files::read_wkt(text, name);
  if (format == "lar") return files::read_lar(text, name);
  throw Error(ErrorCode::BadInput, "texts are not read as results in this format", {}, format);
}

/// Gives a result the name of the function that made it.
void rename(Answer& answer, const std::string& engine) {
  answer.engine = answer.title = engine;
  for (Explained& failure : answer.failures) failure.cause.stage = engine;
}

DoubleArray coords_of(const FloatComplex& complex) {
  std::vector<double> coords;
  for (const PointD& p : complex.vertices) coords.insert(coords.end(), {p.x, p.y});
  return array(std::move(coords), 2);
}

IndexArray edges_of(const FloatComplex& complex) {
  std::vector<std::uint32_t> ends;
  for (const Edge& e : complex.edges) {
    for (const std::size_t v : {e.tail, e.head}) ends.push_back(static_cast<std::uint32_t>(v));
  }
  return array(std::move(ends), 2);
}

const char* type_text(const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::Number:
      return "number";
    case Parameter::Type::Integer:
      return "integer";
    case Parameter::Type::Text:
      break;
  }
  return "text";
}

void bind_answer(nb::module_& m) {
  nb::class_<Answer>(m, "Answer", "What an engine, or someone else's program, makes of lines.")
      .def("__repr__", [](const Answer& a) { return "<Answer of " + line_text(a.title) + ">"; })
      .def_ro("engine", &Answer::engine, "Its name; \"files\" for results that were given.")
      .def_ro("version", &Answer::version)
      .def_ro("title", &Answer::title, "In pictures and pages.")
      .def_ro("parameters", &Answer::parameters, "As the engine was run: all that it has.")
      .def_prop_ro(
          "compared", [](const Answer& a) { return to_text(a.compared); },
          "Which cells it has: \"all\", \"graph\" (no faces), \"faces\" (polygons alone), ...")
      .def_ro("radius", &Answer::radius, "Vertices nearer than this are one to it; None: none.")
      .def_ro("radius_from", &Answer::radius_from,
              "\"number\", a preset, or \"segment\": a quarter of the shortest one.")
      .def_ro("rejected", &Answer::dropped, "What it left out.")
      .def_ro("remarks", &Answer::remarks)
      .def_ro("stages", &Answer::stages, "In their order; none: it cannot be looked into.")
      .def_prop_ro(
          "vertices", [](const Answer& a) { return coords_of(a.complex); }, "(V, 2).")
      .def_prop_ro(
          "edges", [](const Answer& a) { return edges_of(a.complex); },
          "Pairs of vertices, (E, 2).")
      .def("rename", &rename, nb::arg("engine"));
}

void bind_results(nb::module_& m) {
  m.def(
      "read_result", [](const std::string& path) { return files::answer(files::read(path)); },
      nb::arg("path"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "read_result_text",
      [](const std::string& format, const std::string& text, const std::string& name) {
        return files::answer(read_result_text(format, text, name));
      },
      nb::arg("format"), nb::arg("text"), nb::arg("name"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "result_of",
      [](const ExactComplex& complex, const std::string& name) {
        files::Result result;
        result.file = name;
        result.complex = complex;
        result.has_faces = true;
        return files::answer(std::move(result));
      },
      nb::arg("complex"), nb::arg("name"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace

void bind_engine(nb::module_& m) {
  nb::class_<Parameter>(m, "Parameter", "Something that the user of an engine may choose.")
      .def_ro("name", &Parameter::name)
      .def_prop_ro("type", &type_text, "\"number\", \"integer\" or \"text\".")
      .def_ro("description", &Parameter::description)
      .def_ro("choices", &Parameter::choices, "Of a text; none: any.");
  nb::class_<Cause>(m, "Cause", "Why a finding is there.")
      .def_ro("stage", &Cause::stage,
              "\"drawing\", \"parse\", \"transform\", a stage of the engine, or its name.")
      .def_ro("round", &Cause::round, "Of an engine that repeats stages, from 1; 0 outside.")
      .def_ro("rule", &Cause::rule, "The name of the divergence.")
      .def_ro("explanation", &Cause::explanation, "One sentence: what the stage did there.")
      .def_ro("advice", &Cause::advice, "One sentence: what would have avoided it.")
      .def_ro("confirmed", &Cause::confirmed,
              "Whether exact continuation of the stage's output, and of its input, proves it.")
      .def_ro("remade", &Cause::remade,
              "Whether the finding is there again with the stage replaced by an exact one.")
      .def_ro("distance", &Cause::distance, "How far apart what was joined there is.")
      .def_ro("radius_without", &Cause::radius_without,
              "The largest radius tried with which the finding is not there.")
      .def_ro("others", &Cause::with, "Other stages that have a part in it.");
  bind_answer(m);
  bind_results(m);
  m.def("engine_names", [] {
    std::vector<std::string> names;
    for (const Engine& engine : engines()) names.push_back(engine.name);
    return names;
  });
  m.def("engine_titles", [] {
    std::vector<std::tuple<std::string, std::string, std::string>> titles;
    for (const Engine& e : engines()) titles.emplace_back(e.name, e.version, e.title);
    return titles;
  });
  m.def(
      "engine_parameters",
      [](const std::string& name, const Folders& folders) {
        return engine_of(name, folders).parameters;
      },
      nb::arg("name"), nb::arg("folders"), nb::call_guard<nb::gil_scoped_release>());
  m.def("engine_answer", &engine_answer, nb::arg("name"), nb::arg("lines"), nb::arg("unit_square"),
        nb::arg("settings"), nb::arg("svg_file"), nb::arg("folders"), nb::arg("threads"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "on_unit_square", [](const SegmentSet& lines) { return lar::to_unit_square(lines); },
      nb::arg("lines"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
