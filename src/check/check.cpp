#include "plumbline/check.hpp"

#include "check/line_work.hpp"
#include "plumbline/lar.hpp"

namespace plumbline {

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
  result.doubles_complex = checking::arrange(checking::rounded(result.input), options.threads);
  result.conversion = crosscheck(result.exact_complex, result.doubles_complex, tolerance);
  return result;
}

}  // namespace plumbline
