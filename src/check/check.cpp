#include "plumbline/check.hpp"

#include <algorithm>

#include "check/attribute.hpp"
#include "check/try_radii.hpp"
#include "check/without_drift.hpp"
#include "compare/wrong_cells.hpp"
#include "geometry/point_tree.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline {
namespace {

/// Of a drawing's largest coordinate: 128 roundings to doubles.
constexpr double kLeastTolerance = 0x1p-46;

double tolerance_of_drawing(const ExactComplex& complex) {
  if (complex.vertices.empty()) return 0;
  PointD low = nearest(complex.vertices.front()), high = low;
  for (const Point& vertex : complex.vertices) {
    const PointD p = nearest(vertex);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const double largest = std::max({-low.x, -low.y, high.x, high.y});
  return std::max(kToleranceOfAnswers * side, kLeastTolerance * largest);
}

Comparison compare_answer(const ExactComplex& exact_complex, const Answer& answer,
                          double tolerance) {
  if (answer.exact_complex) {
    return compare(exact_complex, *answer.exact_complex, tolerance, answer.compared);
  }
  if (answer.compared == Compared::All) return compare(exact_complex, answer.complex, tolerance);
  return compare(exact_complex, exact(answer.complex), tolerance, answer.compared);
}

void tell(const CheckOptions& options, const std::string& part) {
  if (options.begins) options.begins(part);
}

/// The second answer, and why it differs from the first.
void compare_conversion(Check& result, const CheckOptions& options) {
  const double tolerance = result.comparison.tolerance;
  tell(options, "arranging the drawing in doubles");
  result.doubles_complex = arrange(rounded(result.input), options.threads);
  result.conversion = compare(result.exact_complex, result.doubles_complex, tolerance);
  std::optional<Comparison> parsed;
  if (options.parsed && !result.conversion.agree()) {
    parsed = compare_steps::compare_cells(result.exact_complex, arrange(options.parsed()),
                                          tolerance, true);
  }
  result.conversion_causes = check_steps::attribute_conversion(
      result.conversion, parsed ? &*parsed : nullptr, result.exact_complex);
}

/// The stages that made the findings.
void explain(Check& result, const CheckOptions& options) {
  const check_steps::Converted converted{result.doubles_complex, result.conversion,
                                         result.conversion_causes};
  if (!result.answer.trace) {
    result.causes = check_steps::attribute_to_engine(result.comparison, result.answer.engine,
                                                     result.exact_complex, converted);
    return;
  }
  if (result.agree()) return;
  const std::size_t count = result.comparison.findings.size();
  tell(options, "looking for the stages that made " + std::to_string(count) + " findings");
  const auto run = result.answer.trace();
  result.causes = check_steps::attribute(result.comparison, result.exact_complex,
                                         result.answer.complex, *run, converted, options.threads);
}

/// What the engine itself says is wrong are findings, too.
void add_failures(Check& result) {
  for (const Explained& failure : result.answer.failures) {
    result.comparison.findings.push_back(failure.finding);
    result.causes.push_back(failure.cause);
  }
}

std::size_t crowded_vertices(const ExactComplex& complex, double radius) {
  const FloatComplex rounded = nearest(complex);
  const PointTree tree(rounded.vertices);
  return static_cast<std::size_t>(
      std::count_if(rounded.vertices.begin(), rounded.vertices.end(),
                    [&](const PointD& p) { return tree.nearest(p, 2, radius).size() > 1; }));
}

/// Adds what the answer left out, and its remarks, to those of the drawing's reader.
void add_dropped(SegmentSet& input, const Answer& answer) {
  if (answer.dropped.empty() && answer.remarks.empty()) return;
  const std::uint32_t file = input.add_file(answer.title);
  for (Rejected item : answer.dropped) {
    item.source.file = file;
    input.rejected.push_back(std::move(item));
  }
  for (Remark item : answer.remarks) {
    item.source.file = file;
    input.remarks.push_back(std::move(item));
  }
}

}  // namespace

Check check(SegmentSet input, ExactComplex exact_complex, Answer answer,
            const CheckOptions& options) {
  Check result;
  result.input = std::move(input);
  result.exact_complex = std::move(exact_complex);
  result.answer = std::move(answer);
  const double tolerance = options.tolerance ? *options.tolerance
                           : result.answer.radius
                               ? *result.answer.radius
                               : std::max(result.answer.precision.value_or(0),
                                          tolerance_of_drawing(result.exact_complex));
  tell(options, "comparing with " + result.answer.title);
  result.comparison = compare_answer(result.exact_complex, result.answer, tolerance);
  compare_conversion(result, options);
  explain(result, options);
  result.drift = drift(result.input, result.exact_complex);
  check_steps::take_from_drawing(result, options.threads);
  check_steps::try_radii(result, options.tolerance, options.threads);
  add_failures(result);
  result.groups =
      group_findings(result.comparison, result.causes, result.exact_complex, result.answer.complex);
  const bool is_own_drift = result.own_findings() == result.comparison.findings.size();
  if (!is_own_drift && result.answer.radius) {
    result.crowded_vertices = crowded_vertices(result.exact_complex, *result.answer.radius);
  }
  add_dropped(result.input, result.answer);
  return result;
}

std::size_t Check::own_findings() const {
  return static_cast<std::size_t>(std::count_if(
      causes.begin(), causes.end(), [](const Cause& cause) { return cause.stage == kDrawing; }));
}

}  // namespace plumbline
