#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"

namespace plumbline::cli {

ExitCode run(const CheckArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json"}}, {arguments.picture, {".svg"}}});
  const Drawing drawing = load(arguments);
  const lar::Result lar_result = [&] {
    const Progress progress("running the float LAR pipeline");
    return lar::arrange(drawing.input, {arguments.radius});
  }();
  const double radius = lar_result.trace.radius;
  const Crosscheck verdict = [&] {
    const Progress progress("comparing");
    return crosscheck(drawing.complex, lar_result.complex, arguments.tolerance.value_or(radius));
  }();
  const CheckedDrawing checked{drawing.input, drawing.complex, lar_result.complex, radius, verdict};
  if (arguments.output) write_file(*arguments.output, report_json(checked));
  if (arguments.picture) write_file(*arguments.picture, report_svg(checked));
  fmt::print("{}", report_text(checked));
  return verdict.agree() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
