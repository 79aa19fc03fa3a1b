#include "plumbline/check.hpp"

#include "check/attribute.hpp"
#include "check/line_work.hpp"
#include "check/repaired_run.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/lar.hpp"

namespace plumbline {
namespace {

/// The second answer, and why it differs from the first.
void compare_conversion(Check& result, const CheckOptions& options, double tolerance) {
  result.doubles_complex = checking::arrange(checking::rounded(result.input), options.threads);
  result.conversion = crosscheck(result.exact_complex, result.doubles_complex, tolerance);
  std::optional<Crosscheck> parsed;
  if (options.parsed && !result.conversion.agree())
    parsed = crosscheck(result.exact_complex, arrange(options.parsed()), tolerance);
  checking::attribute_conversion(result.conversion, parsed ? &*parsed : nullptr,
                                 result.exact_complex);
}

}  // namespace

Check check(SegmentSet input, ExactComplex exact_complex, const CheckOptions& options) {
  Check result;
  result.input = std::move(input);
  result.exact_complex = std::move(exact_complex);
  lar::Result run = lar::arrange(result.input, {options.radius, options.threads});
  result.float_complex = std::move(run.complex);
  result.result = "repaired";
  result.radius = run.trace.radius;
  const double tolerance = options.tolerance.value_or(run.trace.radius);
  result.crosscheck = crosscheck(result.exact_complex, result.float_complex, tolerance);
  compare_conversion(result, options, tolerance);
  if (!result.crosscheck.agree()) {
    const checking::RepairedRun traced(result.input, run.trace, options.threads);
    checking::attribute(result.crosscheck, result.exact_complex, result.float_complex, traced,
                        result.conversion, options.threads);
  }
  return result;
}

}  // namespace plumbline
