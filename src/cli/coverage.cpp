#include "plumbline/coverage.hpp"

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
#include "plumbline/round.hpp"
#include "plumbline/validity.hpp"

namespace plumbline::cli {
namespace {

CleanOptions options_of(const CoverageArguments& arguments) {
  for (const auto& limit : {arguments.width, arguments.area}) {
    if (!limit || sgn(*limit) >= 0) continue;
    throw Error(ErrorCode::BadInput, "a limit is not negative", {}, exact_text(*limit));
  }
  CleanOptions options;
  options.policy = arguments.policy;
  options.gaps = {arguments.width, arguments.area};
  if (!arguments.all_overlaps) options.overlaps = options.gaps;
  return options;
}

std::vector<std::string> elements_of(const Coverage& coverage, const std::vector<RegionId>& ids,
                                     const SegmentSet& input) {
  std::vector<std::string> texts;
  for (const RegionId r : ids) texts.push_back(source_text(coverage.polygons[r], input));
  return texts;
}

Summary summary_of(const CoverageFault& fault, const Coverage& coverage, const SegmentSet& input) {
  const PointD at = nearest(fault.at);
  Summary summary;
  summary.set("kind", to_text(fault.kind));
  summary.set("features", elements_of(coverage, fault.polygons, input));
  summary.set("at", std::vector<double>{at.x, at.y});
  summary.set("at_exact", std::vector<std::string>{exact_text(fault.at.x), exact_text(fault.at.y)});
  if (fault.kind == CoverageFaultKind::UnmatchedVertex) return summary;
  summary.set("area", nearest_double(fault.area));
  summary.set("area_exact", exact_text(fault.area));
  summary.set("width", fault.width);
  return summary;
}

/// Whether any is within the limits.
bool set_faults(const std::vector<CoverageFault>& faults, const Coverage& coverage,
                const CleanOptions& options, const SegmentSet& input, Report& report) {
  std::vector<Summary> within, beyond;
  for (const CoverageFault& fault : faults) {
    (is_within(fault, options) ? within : beyond).push_back(summary_of(fault, coverage, input));
  }
  report.set("valid", within.empty());
  report.set("polygons", coverage.polygons.size());
  report.set("faults", within);
  report.set("beyond_limits", beyond);
  return !within.empty();
}

void set_changes(const CleanCoverage& clean, const SegmentSet& input, Report& report) {
  std::vector<Summary> changes;
  for (const Reassigned& change : clean.changes) {
    changes.push_back(summary_of(change.fault, clean.coverage, input));
    changes.back().set("to", source_text(clean.coverage.polygons[change.to], input));
  }
  report.set("changes", changes);
  report.set("vanished", elements_of(clean.coverage, clean.vanished, input));
}

/// Polygons that are invalid by themselves, or left out since a ring is open.
void tell_invalid(const std::vector<PolygonValidity>& polygons, std::size_t taken, Report& report) {
  std::size_t invalid = 0;
  for (const PolygonValidity& polygon : polygons) invalid += polygon.is_valid() ? 0 : 1;
  const std::size_t open = polygons.size() - taken;
  report.set("invalid_polygons", invalid);
  report.set("open_polygons", open);
  if (invalid == 0) return;
  report.print("not valid by themselves, covering what is within an odd number of rings: {}{}\n",
               invalid, open > 0 ? fmt::format("; left out, since a ring is open: {}", open) : "");
  report.print("(plumbline validity tells why)\n");
}

void write_clean(const Output& output, const CoverageArguments& arguments, const Drawing& drawing,
                 const Coverage& clean, Report& report) {
  const Rounding rounding = [&] {
    const Progress progress(fmt::format("rounding {} vertices", clean.complex.vertices.size()),
                            arguments);
    return safely_rounded(clean.complex, {}, {arguments.threads, {}});
  }();
  write_polygons(output, arguments, drawing, drawn_polygons(clean, drawing.input, rounding),
                 note_of(rounding), report);
}

}  // namespace

ExitCode run(const CoverageArguments& arguments, Report& report) {
  const Output output{arguments.output, feature_formats(), arguments.format};
  if (check_outputs(arguments.file, {output})) report.leave_standard_output();
  if (output.file && !arguments.clean) {
    throw Error(ErrorCode::BadInput, "-o writes the clean polygons, so it needs --clean");
  }
  const CleanOptions options = options_of(arguments);
  const Drawing drawing = load(arguments);
  const SegmentSet& input = drawing.input;
  ensure_all_drawn(arguments, input);
  const Coverage found = coverage(input, drawing.complex);
  ensure_some(found.polygons.size(), arguments.file);
  const std::vector<CoverageFault> all = [&] {
    const Progress progress("looking for overlaps and gaps", arguments);
    return faults(found, input);
  }();
  set_losses(report, input);
  const bool is_faulty = set_faults(all, found, options, input, report);
  const std::string text = to_text(found, all, options, input, arguments.listed);
  report.set_headline(text.substr(0, text.find('\n')));
  ExitCode code = is_faulty ? kDisagree : kAgree;
  if (arguments.clean) {
    const CleanCoverage clean = cleaned(found, input, all, options);
    set_changes(clean, input, report);
    report.print("{}", to_text(clean, all, input, arguments.listed));
    if (output.file) write_clean(output, arguments, drawing, clean.coverage, report);
    const auto is_left = [&](const CoverageFault& fault) { return !is_within(fault, options); };
    code = std::ranges::any_of(all, is_left) ? kDisagree : kAgree;
  } else {
    report.print("{}", text);
  }
  tell_invalid(validity(input, drawing.complex), found.polygons.size(), report);
  return code;
}

}  // namespace plumbline::cli
