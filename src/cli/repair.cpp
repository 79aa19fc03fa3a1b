#include "plumbline/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/formats.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/repair_rules.hpp"
#include "cli/report.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kRounded = "nearest doubles";

/// All lines, anew.
std::string content(std::string_view format, const SegmentSet& output) {
  if (format == "lines") return to_lines(output);
  if (format == "svg") return to_svg(output);
  return feature_file(format,
                      {{line_layer(output)}, output.crs, kRounded, output.layers, output.unit});
}

/// "3 ARC, 1 SPLINE": of elements that were no lines.
std::string became_lines(const std::vector<Source>& replaced) {
  std::map<std::string, std::size_t> counts;
  for (const Source& source : replaced) {
    if (source.element != "LINE" && source.element != "line") ++counts[source.element];
  }
  std::string text;
  for (const auto& [element, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, line_text(element));
  }
  return text;
}

/// Writes a drawing made of that which was read: into the file that it had, as far as that goes.
void write_drawing(const RepairArguments& arguments, const Output& file, const SegmentSet& input,
                   const SegmentSet& output, Report& report) {
  const std::string_view format = format_of(file);
  std::string text;
  if (format == "dxf" || format == "svg") {
    PatchedFile patched = patched_file(arguments.file, format, arguments.reading, input, output);
    report.set("patched", patched.why_not.empty());
    if (patched.why_not.empty()) {
      const std::string lines = arguments.undo ? "" : became_lines(patched.replaced);
      report.set("replaced_elements", patched.replaced.size());
      report.print("all but {} element{} stay as they are in the file{}\n", patched.replaced.size(),
                   patched.replaced.size() == 1 ? "" : "s",
                   lines.empty() ? "" : "; now lines: " + lines);
      text = std::move(patched.text);
    } else {
      report.print("lines alone are written, of all elements: {}\n", patched.why_not);
    }
  }
  write_file(*file.file, text.empty() ? content(format, output) : text);
  report.say_written(*file.file);
}

/// How many of the lines that a repair made have ends that are no decimals.
std::size_t count_rounded(const SegmentSet& input, const Repair& repair) {
  std::size_t count = 0;
  for (const NetChange& change : net_changes(input, repair)) {
    count +=
        static_cast<std::size_t>(std::ranges::count_if(change.after, [](const Segment& segment) {
          return to_text(segment).find('/') != std::string::npos;
        }));
  }
  return count;
}

/// How many edits of each kind, how many faces of each fate.
void set_counts(Report& report, const Repair& repair) {
  report.set("edits", repair.edits.size());
  std::array<std::size_t, kEditKinds> kinds{};
  for (const Edit& edit : repair.edits) ++kinds.at(static_cast<std::size_t>(edit.kind));
  for (std::size_t kind = 0; kind < kEditKinds; ++kind) {
    report.set(to_text(static_cast<EditKind>(kind)), kinds[kind]);
  }
  report.set("refused", repair.refused.size());
  report.set("given_up", std::ranges::count_if(repair.refused, [](const Refusal& refusal) {
               return refusal.reason.starts_with("given up as a whole");
             }));
  for (const FaceFate fate :
       {FaceFate::Closed, FaceFate::Split, FaceFate::Joined, FaceFate::Opened, FaceFate::Changed}) {
    report.set("faces_" + to_text(fate),
               std::ranges::count(repair.faces, fate, &FaceOutcome::fate));
  }
  report.set("tolerances", to_text(repair.tolerances));
  report.set("reasons", repair.reasons);
}

/// Whether elements stay what they are, in the input's own file; else lines alone are written.
bool keeps_shapes(const RepairArguments& arguments, const Output& output) {
  if (!output.file) return true;
  const std::string_view format = format_of(output);
  const std::string ending = std::filesystem::path(arguments.file).extension().string();
  return (format == "dxf" || format == "svg") && matches_pattern(ending, "." + std::string(format));
}

/// Whether what is written has layers that are read again.
bool keeps_layers(const Output& output) {
  if (!output.file) return true;
  const std::string_view format = format_of(output);
  return format != "lines" && format != "wkt" && format != "wkb" && format != "csv";
}

SegmentSet drawing_of(const RepairArguments& arguments) {
  const Progress progress("reading " + arguments.file, arguments);
  return evaluate(read(arguments.file, arguments.reading), limits_of(arguments));
}

/// Writes what the repaired drawing was made of.
ExitCode run_undo(const RepairArguments& arguments, const Output& output, Report& report) {
  const RepairLog log = read_repair_log(*arguments.undo);
  const std::vector<NetChange>& changes = log.changes;
  const SegmentSet repaired = drawing_of(arguments);
  const SegmentSet original = undo(repaired, log);
  std::size_t before = 0, after = 0;
  for (const NetChange& change : changes) {
    before += change.before.size();
    after += change.after.size();
  }
  set_input(report, original);
  report.set("changes", changes.size());
  report.print("{} changes undone: {} lines gave way to the {} that were there\n", changes.size(),
               after, before);
  write_drawing(arguments, output, repaired, original, report);
  return kAgree;
}

}  // namespace

ExitCode run(const RepairArguments& arguments, Report& report) {
  const Output output{arguments.output, repair_formats(), arguments.format};
  if (check_outputs(arguments.file, {output,
                                     {arguments.log, {"json"}},
                                     {arguments.findings, finding_formats()},
                                     {arguments.picture, {"svg"}},
                                     {arguments.report, {"html"}}})) {
    report.leave_standard_output();
  }
  if (arguments.undo) return run_undo(arguments, output, report);
  const SegmentSet input = drawing_of(arguments);
  ensure_all_drawn(arguments, input);
  const Repair repaired = [&] {
    const Progress progress(fmt::format("repairing {} segments", input.segments.size()), arguments);
    RepairOptions options = arguments.repair;
    options.keeps_common_sides = keeps_shapes(arguments, output);
    options.keeps_layers = keeps_layers(output);
    return repair(input, options);
  }();
  set_input(report, input);
  set_counts(report, repaired);
  const bool is_dry = arguments.dry_run || !arguments.output;
  report.set("dry_run", is_dry);
  report.print("{}", to_text(repaired, input, arguments.listed));
  const auto write = [&](const std::string& file, const std::string& text) {
    write_file(file, text);
    report.say_written(file);
  };
  if (arguments.compare) tell_rules(input, repaired, report);
  if (arguments.log) write(*arguments.log, to_json(repaired, input));
  if (arguments.findings) {
    write(*arguments.findings,
          feature_file(format_of({arguments.findings, finding_formats()}),
                       {{edit_layer(repaired, input)}, input.crs, "", {}, input.unit}));
  }
  if (arguments.picture || arguments.report) {
    const auto [before, after] = [&] {
      const Progress progress("drawing the repair", arguments);
      return std::pair{arrange(input), arrange(repaired.output)};
    }();
    if (arguments.picture) write(*arguments.picture, to_svg(repaired, input, before, after));
    if (arguments.report) write(*arguments.report, to_html(repaired, input, before, after));
  }
  if (is_dry) {
    report.print("a dry run: the repaired drawing is not written{}\n",
                 arguments.output ? "" : " (-o FILE)");
  } else {
    write_drawing(arguments, output, input, repaired.output, report);
    const std::size_t rounded = format_of(output) == "lines" ? 0 : count_rounded(input, repaired);
    report.set("rounded_lines", rounded);
    if (rounded > 0) {
      report.print("{} line{} with ends at fractions, rounded to doubles; a .lines file is exact\n",
                   rounded, rounded == 1 ? "" : "s");
    }
  }
  return repaired.refused.empty() ? kAgree : kDisagree;
}

}  // namespace plumbline::cli
