#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"

namespace plumbline::cli {
namespace {

Check compare(const CheckArguments& arguments) {
  std::optional<ForeignResult> foreign;  // read first: what is malformed is told at once
  if (arguments.against) foreign = read_result(*arguments.against);
  Drawing drawing = load(arguments);
  const Progress progress(foreign ? "comparing with " + foreign->file
                                  : "running the float LAR pipeline and comparing");
  const auto parsed = [&] { return evaluate(rounded(std::move(drawing.structure))); };
  const CheckOptions options{arguments.radius, arguments.tolerance, parsed, arguments.threads};
  return foreign ? check_against(std::move(drawing.input), std::move(drawing.complex),
                                 std::move(*foreign), options)
                 : check(std::move(drawing.input), std::move(drawing.complex), options);
}

}  // namespace

ExitCode run(const CheckArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json"}},
                                 {arguments.picture, {".svg"}},
                                 {arguments.report, {".html"}},
                                 {arguments.findings, {".geojson", ".json"}}});
  const Check result = compare(arguments);
  if (arguments.output) write_file(*arguments.output, report_json(result));
  if (arguments.picture) write_file(*arguments.picture, report_svg(result));
  if (arguments.report) write_file(*arguments.report, report_html(result));
  if (arguments.findings) write_file(*arguments.findings, report_geojson(result));
  fmt::print("{}", report_text(result));
  return result.agree() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
