#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"

namespace plumbline::cli {

ExitCode run(const CheckArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json"}},
                                 {arguments.picture, {".svg"}},
                                 {arguments.report, {".html"}},
                                 {arguments.findings, {".geojson", ".json"}}});
  Drawing drawing = load(arguments);
  const Check result = [&] {
    const Progress progress("running the float LAR pipeline and comparing");
    const auto parsed = [&] { return evaluate(rounded(std::move(drawing.structure))); };
    return check(std::move(drawing.input), std::move(drawing.complex),
                 {arguments.radius, arguments.tolerance, parsed, arguments.threads});
  }();
  if (arguments.output) write_file(*arguments.output, report_json(result));
  if (arguments.picture) write_file(*arguments.picture, report_svg(result));
  if (arguments.report) write_file(*arguments.report, report_html(result));
  if (arguments.findings) write_file(*arguments.findings, report_geojson(result));
  fmt::print("{}", report_text(result));
  return result.agree() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
