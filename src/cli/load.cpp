#include "cli/load.hpp"

#include <fmt/format.h>

#include "cli/progress.hpp"

namespace plumbline::cli {
namespace {

void ensure_valid(const std::vector<Violation>& violations) {
  if (violations.empty()) return;
  const Violation& first = violations.front();
  throw Error(ErrorCode::Internal,
              fmt::format("the exact arrangement breaks an invariant ({}): {} at {}",
                          to_text(first.invariant), first.message, to_text(first.where)));
}

}  // namespace

Drawing load(const DrawingArguments& arguments) {
  Drawing drawing;
  {
    const Progress progress("reading " + arguments.file);
    drawing.structure = read(arguments.file, arguments.reading);
    drawing.input = evaluate(drawing.structure, limits_of(arguments));
    if (arguments.unit_square) drawing.input = lar::to_unit_square(drawing.input);
  }
  {
    Progress progress(fmt::format("arranging {} segments", drawing.input.segments.size()));
    const auto tell = [&](double part) {
      progress.tell(part);
      return true;
    };
    drawing.complex = arrange(drawing.input, arguments.engine, {arguments.threads, tell});
  }
  if (arguments.verify) {
    const Progress progress("arranging with the other engine");
    const Engine other = arguments.engine == Engine::Cgal ? Engine::Bucket : Engine::Cgal;
    ensure(arrange(drawing.input, other, {arguments.threads, {}}) == drawing.complex,
           "the two engines differ");
  }
  const Progress progress(fmt::format("validating {} edges", drawing.complex.edge_count()));
  ensure_valid(validate(drawing.complex));
  ensure_valid(validate_coverage(drawing.complex, drawing.input));
  return drawing;
}

}  // namespace plumbline::cli
