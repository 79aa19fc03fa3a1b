#include "plumbline/validity.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/polygons_file.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output/polygons.hpp"

namespace plumbline::cli {
namespace {

Source source_of(const PolygonValidity& polygon, const SegmentSet& input) {
  return input.sources[input.segment_source[first_segment(input, polygon)]];
}

Summary summary_of(const RingProblem& problem, const PolygonValidity& polygon,
                   const SegmentSet& input) {
  const PointD at = nearest(problem.where);
  Summary summary;
  summary.set("kind", to_text(problem.fault));
  summary.set("reason", jts_name(problem.fault));
  summary.set("features",
              std::vector<std::string>{to_text(source_of(polygon, input), input.files)});
  summary.set("at", std::vector<double>{at.x, at.y});
  summary.set("at_exact",
              std::vector<std::string>{exact_text(problem.where.x), exact_text(problem.where.y)});
  summary.set("text", describe(problem, input));
  return summary;
}

std::size_t set_faults(const std::vector<PolygonValidity>& polygons, const SegmentSet& input,
                       Report& report) {
  std::vector<Summary> faults;
  std::size_t invalid = 0;
  for (const PolygonValidity& polygon : polygons) {
    invalid += polygon.is_valid() ? 0 : 1;
    for (const RingProblem& problem : polygon.problems) {
      faults.push_back(summary_of(problem, polygon, input));
    }
  }
  report.set("valid", invalid == 0);
  report.set("polygons", polygons.size());
  report.set("invalid_polygons", invalid);
  report.set("faults", faults);
  return invalid;
}

DrawnPolygon drawn(const SegmentSet& input, const PolygonValidity& polygon, ValidMeaning meaning) {
  const RegionPolygons made = made_valid(input, polygon, meaning);
  DrawnPolygon result{source_of(polygon, input), polygon_parts(made), polygon.is_valid(), 0};
  for (const Rational& area : made.areas) result.area += area;
  return result;
}

/// Says what became of invalid polygons.
void tell_made(const std::vector<DrawnPolygon>& polygons, const SegmentSet& input, Report& report) {
  std::vector<Summary> changes;
  std::size_t empty = 0;
  for (const DrawnPolygon& polygon : polygons) {
    if (polygon.is_as_drawn) continue;
    Summary& change = changes.emplace_back();
    change.set("feature", to_text(polygon.source, input.files));
    change.set("parts", polygon.parts.size());
    change.set("area", nearest_double(polygon.area));
    change.set("area_exact", exact_text(polygon.area));
    if (polygon.parts.empty()) ++empty;
  }
  report.set("changes", changes);
  report.print("made valid: {}{}\n", changes.size(),
               empty > 0 ? fmt::format("; of {} nothing is left: they have no area", empty) : "");
}

}  // namespace

ExitCode run(const ValidityArguments& arguments, Report& report) {
  const Output output{arguments.output, feature_formats(), arguments.format};
  if (check_outputs(arguments.file, {output})) report.leave_standard_output();
  if (output.file && !arguments.meaning) {
    throw Error(ErrorCode::BadInput,
                "-o writes valid polygons: --make-valid says what the invalid ones cover");
  }
  const Drawing drawing = load(arguments);
  const SegmentSet& input = drawing.input;
  ensure_all_drawn(arguments, input);
  const std::vector<PolygonValidity> polygons = [&] {
    const Progress progress("looking at rings", arguments);
    return validity(input, drawing.complex);
  }();
  ensure_some(polygons.size(), arguments.file);
  set_losses(report, input);
  const std::size_t invalid = set_faults(polygons, input, report);
  const std::string text = to_text(polygons, input, arguments.listed);
  report.set_headline(text.substr(0, text.find('\n')));
  report.print("{}", text);
  if (arguments.meaning) {
    std::vector<DrawnPolygon> now;
    {
      const Progress progress("making polygons valid", arguments);
      for (const PolygonValidity& polygon : polygons) {
        now.push_back(drawn(input, polygon, *arguments.meaning));
      }
    }
    tell_made(now, input, report);
    if (output.file) {
      write_polygons(output, arguments, drawing, now,
                     "nearest doubles, each polygon proven to be valid", report);
    }
  }
  return invalid > 0 ? kDisagree : kAgree;
}

}  // namespace plumbline::cli
