#include "plumbline/check.hpp"

#include <algorithm>

#include "check/attribute.hpp"
#include "engine/line_work.hpp"
#include "engines/inters/explain/run.hpp"
#include "engines/inters/explain/svg_lines.hpp"
#include "engines/lar/explain/run.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"

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

/// Adds the notes on the result to those on the drawing.
void add_notes(SegmentSet& input, ForeignResult& foreign) {
  const std::uint32_t file = input.add_file(foreign.file);
  for (Rejected& item : foreign.rejected) {
    item.source.file = file;
    input.rejected.push_back(std::move(item));
  }
}

double foreign_tolerance(const ExactComplex& complex) {
  if (complex.vertices.empty()) return 0;
  PointD low = nearest(complex.vertices.front()), high = low;
  for (const Point& vertex : complex.vertices) {
    const PointD p = nearest(vertex);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const double largest = std::max({-low.x, -low.y, high.x, high.y});
  return std::max(kForeignTolerance * side, lar::kLeastRelativeRadius * largest);
}

/// The answer of the published pipeline, and why it differs from the first.
void compare_published(Check& result, const CheckOptions& options) {
  namespace published = lar::published;
  published::Options run;
  run.decimals = options.published->decimals;
  run.radius = options.radius.value_or(published::kRadius);
  run.threads = options.threads;
  const published::Trace trace =
      published::run(options.published->lines.value_or(published::lines(result.input)), run);
  const checking::PublishedRun traced(trace, options.published->result, options.threads);
  result.float_complex = traced.complex();
  result.result = "published";
  result.radius = run.radius;
  const double tolerance = options.tolerance.value_or(run.radius);
  result.crosscheck = crosscheck(result.exact_complex, exact(result.float_complex), tolerance,
                                 traced.has_faces() ? Compared::All : Compared::Graph);
  compare_conversion(result, options, tolerance);
  checking::attribute(result.crosscheck, result.exact_complex, result.float_complex, traced,
                      result.conversion, options.threads);
  checking::blame_missed_junctions(result.crosscheck, result.exact_complex, traced);
  for (Finding& finding : result.crosscheck.findings) traced.refine(finding);
  for (Finding& failure : traced.failures())
    result.crosscheck.findings.push_back(std::move(failure));
  if (!options.published->svg) return;
  for (Finding& misread : checking::svg_to_lines_findings(*options.published->svg, result.input))
    result.crosscheck.findings.push_back(std::move(misread));
}

}  // namespace

Check check(SegmentSet input, ExactComplex exact_complex, const CheckOptions& options) {
  Check result;
  result.input = std::move(input);
  result.exact_complex = std::move(exact_complex);
  if (options.published) {
    compare_published(result, options);
    return result;
  }
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

Check check_against(SegmentSet input, ExactComplex exact_complex, ForeignResult foreign,
                    const CheckOptions& options) {
  Check result;
  result.input = std::move(input);
  result.exact_complex = std::move(exact_complex);
  result.float_complex = nearest(foreign.complex);
  result.result = foreign.file;
  const double tolerance = options.tolerance.value_or(foreign_tolerance(result.exact_complex));
  result.crosscheck = crosscheck(result.exact_complex, foreign.complex, tolerance,
                                 foreign.has_faces ? Compared::All : Compared::Graph);
  compare_conversion(result, options, tolerance);
  checking::attribute_foreign(result.crosscheck, result.exact_complex, result.conversion);
  add_notes(result.input, foreign);
  return result;
}

}  // namespace plumbline
