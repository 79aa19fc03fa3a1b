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

Drawing load(const std::string& file) {
  Drawing drawing;
  {
    const Progress progress("reading " + file);
    drawing.input = evaluate(read(file));
  }
  {
    const Progress progress(fmt::format("arranging {} segments", drawing.input.segments.size()));
    drawing.complex = arrange(drawing.input);
  }
  const Progress progress(fmt::format("validating {} edges", drawing.complex.edge_count()));
  ensure_valid(validate(drawing.complex));
  ensure_valid(validate_coverage(drawing.complex, drawing.input));
  return drawing;
}

}  // namespace plumbline::cli
