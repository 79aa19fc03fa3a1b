#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"

namespace plumbline::cli {
namespace {

std::optional<PublishedCheck> published_check(const CheckArguments& arguments,
                                              const Structure& structure) {
  if (!arguments.is_published) {
    if (arguments.decimals || arguments.result || arguments.with_svg2lines)
      throw Error(ErrorCode::BadInput,
                  "--decimals, --result and --svg2lines belong to --variant published");
    return std::nullopt;
  }
  PublishedCheck result;
  result.decimals = arguments.decimals.value_or(result.decimals);
  result.result = arguments.result.value_or(result.result);
  if (arguments.unit_square)
    result.lines = lar::published::lines_on_unit_square(evaluate(structure), result.decimals);
  if (arguments.with_svg2lines) {
    if (!arguments.file.ends_with(".svg"))
      throw Error(ErrorCode::BadInput, "svg2lines reads .svg files", {arguments.file, 0, 0});
    std::ifstream file(arguments.file, std::ios::binary);
    result.svg.emplace(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return result;
}

Check compare(const CheckArguments& arguments) {
  std::optional<ForeignResult> foreign;  // read first: what is malformed is told at once
  if (arguments.against) foreign = read_result(*arguments.against);
  Drawing drawing = load(arguments);
  const Progress progress(foreign ? "comparing with " + foreign->file
                                  : "running the float LAR pipeline and comparing");
  const auto parsed = [&] {
    const SegmentSet input = evaluate(rounded(std::move(drawing.structure)));
    return arguments.unit_square ? lar::to_unit_square(input) : input;
  };
  const CheckOptions options{arguments.radius, arguments.tolerance, parsed, arguments.threads,
                             published_check(arguments, drawing.structure)};
  return foreign ? check_against(std::move(drawing.input), std::move(drawing.complex),
                                 std::move(*foreign), options)
                 : check(std::move(drawing.input), std::move(drawing.complex), options);
}

// Advice runs the pipeline a dozen times: unasked only where that takes a few seconds.
constexpr std::size_t kMostEdgesForAdvice = 20'000;

/// The tolerance ladder where it is shown, right radii where they are asked for or cheap.
Check with_advice(Check result, const CheckArguments& arguments) {
  const bool is_small = result.exact_complex.edge_count() <= kMostEdgesForAdvice;
  // The radii that are tried are those of the repaired variant.
  const bool wants_radii =
      !arguments.is_published && !arguments.against && arguments.advice.value_or(is_small);
  if (!wants_radii && !arguments.plot && !arguments.report) return result;
  Progress progress("looking for critical and right radii");
  AdviceOptions options;
  if (!wants_radii) options.max_runs = 0;
  options.threads = arguments.threads;
  options.progress = [&](double part) {
    progress.tell(part);
    return true;
  };
  return advised(std::move(result), options);
}

}  // namespace

ExitCode run(const CheckArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json"}},
                                 {arguments.picture, {".svg"}},
                                 {arguments.report, {".html"}},
                                 {arguments.plot, {".svg"}},
                                 {arguments.findings, {".geojson", ".json"}}});
  const Check result = with_advice(compare(arguments), arguments);
  if (arguments.output) write_file(*arguments.output, report_json(result));
  if (arguments.picture) write_file(*arguments.picture, report_svg(result));
  if (arguments.report) write_file(*arguments.report, report_html(result));
  if (arguments.findings) write_file(*arguments.findings, report_geojson(result));
  if (arguments.plot) write_file(*arguments.plot, ladder_svg(*result.ladder, result.right_radii));
  fmt::print("{}", report_text(result, arguments.listed));
  return result.agree() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
