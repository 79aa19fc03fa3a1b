#include <fmt/format.h>

#include "plumbline/engines/lar.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline {
namespace {

void ensure_valid(const std::vector<Violation>& violations) {
  if (violations.empty()) return;
  const Violation& first = violations.front();
  throw Error(ErrorCode::Internal,
              fmt::format("the exact arrangement breaks an invariant ({}): {} at {}",
                          to_text(first.invariant), first.message, to_text(first.where)));
}

void tell(const Watch& watch, const std::string& what) {
  if (watch && !watch(what, -1)) throw Error(ErrorCode::Cancelled, what + " was cancelled");
}

ExactComplex arranged(const SegmentSet& input, ExactEngine engine, const DrawingOptions& options,
                      const std::string& what) {
  tell(options.watch, what);
  ArrangeOptions arranging{options.threads, {}};
  if (options.watch) arranging.progress = [&](double part) { return options.watch(what, part); };
  return arrange(input, engine, arranging);
}

void join_drift(Drawing& drawing, const DrawingOptions& options) {
  drawing.joined = drift(drawing.input, drawing.complex);
  if (drawing.joined.places == 0) return;
  tell(options.watch, fmt::format("joining {} places", drawing.joined.places));
  drawing.complex = without_drift(drawing.input, drawing.complex, drawing.joined, options.threads);
  ensure_valid(validate(drawing.complex));
}

}  // namespace

Drawing exact_answer(const std::filesystem::path& file, const DrawingOptions& options) {
  Drawing drawing;
  drawing.file = file;
  drawing.unit_square = options.unit_square;
  tell(options.watch, "reading " + file.string());
  drawing.structure = read(file, options.reading);
  drawing.input = evaluate(drawing.structure, {kMaxEvaluatedWords, options.reading.max_segments});
  if (!options.walls.empty()) drawing.input = on_layers(std::move(drawing.input), options.walls);
  if (options.unit_square) drawing.input = lar::to_unit_square(drawing.input);
  drawing.complex = arranged(drawing.input, options.exact_engine, options,
                             fmt::format("arranging {} segments", drawing.input.segments.size()));
  if (options.both_engines) {
    const ExactEngine other =
        options.exact_engine == ExactEngine::Cgal ? ExactEngine::Bucket : ExactEngine::Cgal;
    ensure(arranged(drawing.input, other, options, "arranging with the other engine") ==
               drawing.complex,
           "the two engines differ");
  }
  tell(options.watch, fmt::format("validating {} edges", drawing.complex.edge_count()));
  ensure_valid(validate(drawing.complex));
  ensure_valid(validate_coverage(drawing.complex, drawing.input));
  if (options.joins_drift) join_drift(drawing, options);
  return drawing;
}

}  // namespace plumbline
