// The commands overlay and select: what regions make together.

#include "plumbline/overlay.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/output/regions.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kWayOut = "; --lenient goes on without it";

SegmentSet read_layer(const OverlayArguments& arguments, const std::string& file) {
  const Progress progress("reading " + file, arguments);
  SegmentSet input = evaluate(read(file, arguments.reading), limits_of(arguments));
  ensure_all_drawn(arguments, file, input.rejected,
                   input.segments.empty() && !(input.rejected.empty() && input.labels.empty()));
  // An empty layer is one; lines in place of polygons are a mistake, and no answer about nothing.
  const bool has_lines = !input.segments.empty();
  if (has_lines && !arguments.lenient &&
      regions(input, RegionKind::Polygon, arguments.rule).empty()) {
    throw Error(ErrorCode::BadInput,
                "nothing of the file is a polygon or a closed line (lines that enclose areas: "
                "plumbline rooms, or arrange --cells faces -o, makes polygons of them)" +
                    std::string(kWayOut),
                {file, 0, 0});
  }
  return input;
}

std::vector<std::string> elements_of(const Overlay& overlay, const std::vector<RegionId>& ids) {
  std::vector<std::string> texts;
  for (const RegionId r : ids) texts.push_back(source_text(overlay.regions[r], overlay.input));
  return texts;
}

void summarise(const Overlay& overlay, OverlayHow how, Report& report) {
  std::vector<Summary> pieces;
  for (const Piece& piece : overlay.pieces) {
    Summary& summary = pieces.emplace_back();
    summary.set("piece", pieces.size());
    summary.set("first", elements_of(overlay, piece.first));
    summary.set("second", elements_of(overlay, piece.second));
    summary.set("area", nearest_double(piece.area));
    summary.set("area_exact", exact_text(piece.area));
  }
  const Rational area = overlay.area();
  report.set("how", to_text(how));
  report.set("polygons", std::vector<double>{
                             static_cast<double>(overlay.first_count),
                             static_cast<double>(overlay.regions.size() - overlay.first_count)});
  report.set("area", nearest_double(area));
  report.set("area_exact", exact_text(area));
  report.set("open_segments", overlay.open.size());
  report.set("pieces", pieces);
}

/// The complex in doubles, proven, and in the format that is asked for.
std::string content(const Output& output, const CommonArguments& manners,
                    const ExactComplex& complex, const SegmentSet& input, std::size_t threads,
                    const std::function<FeatureLayer(const Rounding&)>& layer) {
  const Progress progress(fmt::format("rounding {} vertices", complex.vertices.size()), manners);
  const Rounding rounding = safely_rounded(complex, {}, {threads, {}});
  return feature_file(format_of(output),
                      {{layer(rounding)}, input.crs, note_of(rounding), input.layers, input.unit});
}

void write(const std::string& file, const std::string& text, Report& report) {
  write_file(file, text);
  report.say_written(file);
}

/// Throws: Error BadInput for an output that would be written over the other input.
void ensure_kept(const std::string& input, const std::vector<Output>& outputs) {
  for (const Output& output : outputs) {
    if (output.file && !is_standard_output(*output.file)) check_outputs(input, {output});
  }
}

}  // namespace

ExitCode run(const OverlayArguments& arguments, Report& report) {
  const Output output{arguments.output, feature_formats(), arguments.format};
  const std::vector<Output> outputs{output, {arguments.picture, {"svg"}}};
  if (check_outputs(arguments.file, outputs)) report.leave_standard_output();
  ensure_kept(arguments.second, outputs);
  SegmentSet first = read_layer(arguments, arguments.file);
  const SegmentSet second = read_layer(arguments, arguments.second);
  const Overlay made = [&] {
    const Progress progress(
        fmt::format("laying {} segments over {}", second.segments.size(), first.segments.size()),
        arguments);
    return overlay(std::move(first), second, arguments.how, arguments.rule, arguments.threads);
  }();
  set_losses(report, made.input);
  summarise(made, arguments.how, report);
  report.print("{}", to_text(made, arguments.how, arguments.listed));
  if (output.file) {
    write(*output.file,
          content(output, arguments, made.complex, made.input, arguments.threads,
                  [&](const Rounding& rounding) { return piece_layer(made, rounding); }),
          report);
  }
  if (arguments.picture) write(*arguments.picture, to_svg(made, arguments.how), report);
  return kAgree;
}

ExitCode run(const SelectArguments& arguments, Report& report) {
  const Output output{arguments.output, feature_formats(), arguments.format};
  if (check_outputs(arguments.file, {output, {arguments.picture, {"svg"}}})) {
    report.leave_standard_output();
  }
  const Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, drawing.input);
  const LayerRegions found = layer_regions(drawing.input, arguments.rule);
  if (found.regions.empty()) {
    throw Error(ErrorCode::BadInput, "nothing of the file is a polygon or closes",
                {arguments.file});
  }
  const FaceSet faces =
      select(label(drawing.input, drawing.complex, found.regions), arguments.expression);
  const RegionPolygons selected = region_polygons(drawing.complex, faces);
  Rational area = 0;
  for (const Rational& part : selected.areas) area += part;
  set_losses(report, drawing.input);
  report.set("expression", arguments.expression);
  report.set("regions", found.regions.size());
  report.set("open_segments", found.open.size());
  report.set("polygons", selected.polygons.size());
  report.set("area", nearest_double(area));
  report.set("area_exact", exact_text(area));
  report.print("{}", to_text(selected, found, drawing.input, arguments.listed));
  if (output.file) {
    write(*output.file,
          content(output, arguments, selected.complex, drawing.input, arguments.threads,
                  [&](const Rounding& rounding) { return region_layer(selected, rounding); }),
          report);
  }
  if (arguments.picture) {
    write(*arguments.picture, to_svg(drawing.input, drawing.complex, faces), report);
  }
  return kAgree;
}

}  // namespace plumbline::cli
