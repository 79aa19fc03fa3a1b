#include "cli/load.hpp"

#include <optional>

#include "cli/progress.hpp"

namespace plumbline::cli {

Drawing load(const DrawingArguments& arguments) {
  std::optional<Progress> shown;
  std::string step;
  DrawingOptions options;
  options.reading = arguments.reading;
  options.walls = arguments.walls;
  options.unit_square = arguments.unit_square;
  options.exact_engine = arguments.exact_engine;
  options.both_engines = arguments.both_engines;
  options.joins_drift = arguments.joins_drift;
  options.threads = arguments.threads;
  options.watch = [&](const std::string& what, double part) {
    if (!shown || what != step) shown.emplace(what, arguments);
    step = what;
    if (part >= 0) shown->tell(part);
    return true;
  };
  Drawing drawing = exact_answer(arguments.file, options);
  if (arguments.unit) drawing.input.unit = arguments.unit;
  return drawing;
}

}  // namespace plumbline::cli
