// Wrong answers brought down to a few segments.

#include "plumbline/minimise.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "core.hpp"
#include "plumbline/output/minimised.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::python {
namespace {

/// Segments as rows ax, ay, bx, by that Python may change.
nb::object rows_of(const SegmentSet& drawing) {
  std::vector<double> numbers;
  for (const SegmentD& s : rounded(drawing).segments) {
    numbers.insert(numbers.end(), {s.a.x, s.a.y, s.b.x, s.b.y});
  }
  return array(std::move(numbers), 4).attr("copy")();
}

/// A function of rows as an engine: it returns an Answer, or says in a text how it failed. What it
/// raises ends the work, and is kept.
class FunctionEngine {
 public:
  explicit FunctionEngine(nb::object function) : function_(std::move(function)) {}

  Answer operator()(const SegmentSet& drawing) {
    const nb::gil_scoped_acquire acquire;
    std::string failure;
    try {
      const nb::object result = function_(rows_of(drawing));
      if (nb::isinstance<Answer>(result)) return nb::cast<Answer>(result);
      failure = nb::cast<std::string>(result);
    } catch (const nb::python_error&) {
      raised_ = std::current_exception();
    }
    if (raised_) throw Error(ErrorCode::Cancelled, "the engine was interrupted");
    throw std::runtime_error(failure);
  }
  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  nb::object function_;
  std::exception_ptr raised_;
};

struct Request {
  Parameters parameters;
  MinimiseOptions options;
};

Minimised run(Progress& told, const SegmentSet& drawing, const Engine& engine,
              const Request& request) {
  return told.run([&](const std::function<bool(double)>& callback) {
    MinimiseOptions options = request.options;
    const auto most = static_cast<double>(options.max_runs);
    options.progress = [&](std::size_t runs, std::size_t) {
      return callback(std::min(static_cast<double>(runs) / most, 1.0));
    };
    return minimised(drawing, engine, request.parameters, options);
  });
}

Minimised minimised_by_name(const SegmentSet& drawing, const std::string& name,
                            const std::vector<std::pair<std::string, std::string>>& settings,
                            const std::vector<std::string>& folders,
                            std::optional<double> tolerance, std::size_t max_runs,
                            std::size_t threads, nb::object progress) {
  const std::vector<std::filesystem::path> paths(folders.begin(), folders.end());
  const Engine engine = engine_named(name, engines(), paths);
  Request request;
  for (const auto& [parameter, text] : settings) {
    const auto preset = std::find(kRadiusPresets.begin(), kRadiusPresets.end(), text);
    if (parameter != "radius" || preset == kRadiusPresets.end()) {
      request.parameters[parameter] = parameter_value(engine, parameter, text);
    } else if (const auto radius = preset_radius(text, drawing)) {
      request.parameters[parameter] = *radius;
    }
  }
  request.options.tolerance = tolerance;
  request.options.max_runs = max_runs;
  request.options.threads = threads;
  Progress told(std::move(progress));
  return run(told, drawing, engine, request);
}

Minimised minimised_by_function(const SegmentSet& drawing, const std::string& name,
                                nb::object function, std::optional<double> tolerance,
                                std::size_t max_runs, std::size_t threads, nb::object progress) {
  FunctionEngine called(std::move(function));
  const Engine engine{
      name, "", name, {}, [&](const SegmentSet& lines, const Parameters&, std::size_t) {
        return called(lines);
      }};
  Request request;
  request.options.tolerance = tolerance;
  request.options.max_runs = max_runs;
  request.options.threads = threads;
  Progress told(std::move(progress));
  try {
    return run(told, drawing, engine, request);
  } catch (const Error&) {
    called.rethrow();
    throw;
  }
}

}  // namespace

void bind_minimise(nb::module_& m) {
  nb::class_<Outcome>(m, "Outcome", "What an answer is as a whole.")
      .def_prop_ro("outcome_class", [](const Outcome& o) { return to_text(o.outcome_class); })
      .def_ro("kind", &Outcome::kind)
      .def_ro("finding", &Outcome::finding);
  nb::class_<Minimised>(m, "Minimised", "A drawing that shows what is wrong with an engine.")
      .def_ro("drawing", &Minimised::drawing)
      .def_ro("engine", &Minimised::engine)
      .def_ro("parameters", &Minimised::parameters)
      .def_ro("outcome", &Minimised::outcome)
      .def_ro("check", &Minimised::check)
      .def_ro("segments_before", &Minimised::segments_before)
      .def_ro("runs", &Minimised::runs)
      .def_ro("is_one_minimal", &Minimised::is_one_minimal)
      .def_ro("has_simple_numbers", &Minimised::has_simple_numbers)
      .def_ro("is_representable", &Minimised::is_representable)
      .def_ro("holds_in_decimals", &Minimised::holds_in_decimals)
      .def_ro("radius_before", &Minimised::radius_before)
      .def("to_text", [](const Minimised& x) { return to_text(x); })
      .def("to_lines", [](const Minimised& x) { return to_lines(x); })
      .def("to_svg", [](const Minimised& x) { return to_svg(x); })
      .def(
          "to_issue",
          [](const Minimised& x, const std::string& lines_file, const std::string& picture_file) {
            return to_issue(x, {lines_file, picture_file});
          },
          nb::arg("lines_file"), nb::arg("picture_file"));
  m.def("minimised", &minimised_by_name, nb::arg("drawing"), nb::arg("engine"), nb::arg("settings"),
        nb::arg("folders"), nb::arg("tolerance").none(), nb::arg("max_runs"), nb::arg("threads"),
        nb::arg("progress").none());
  m.def("minimised_by_function", &minimised_by_function, nb::arg("drawing"), nb::arg("name"),
        nb::arg("function"), nb::arg("tolerance").none(), nb::arg("max_runs"), nb::arg("threads"),
        nb::arg("progress").none());
}

}  // namespace plumbline::python
