#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/tiles.hpp"

namespace plumbline::cli {
namespace {

/// Each as an option, in quotes for a shell.
std::string quoted_options(const std::string& name, const std::vector<std::string>& values) {
  std::string options;
  for (const std::string& value : values) {
    options += " " + name + " '";
    for (const char c : line_text(value)) {
      options += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    options += "'";
  }
  return options;
}

/// The options with which a drawing becomes the same segments again.
std::string reading_options(const ReadOptions& reading) {
  std::string options;
  if (!reading.format.empty()) options += " --from " + reading.format;
  if (sgn(reading.chord_tolerance) > 0) {
    options += " --flatten " + exact_text(reading.chord_tolerance);
  }
  if (reading.angle_bound != ReadOptions().angle_bound) {
    options += " --angle " + shortest_text(reading.angle_bound);
  }
  if (!reading.join_curves) options += " --keep-curves";
  if (reading.shortest_decimals) options += " --shortest-decimals";
  if (reading.hidden) options += " --hidden";
  if (reading.hatches) options += " --hatches";
  options += quoted_options("--layers", reading.layers);
  options += quoted_options("--without-layers", reading.without_layers);
  if (reading.layer_property != ReadOptions().layer_property) {
    options += quoted_options("--layer-property", {reading.layer_property});
  }
  return options;
}

void write_certificate(const ArrangeArguments& arguments, const Drawing& drawing, Report& report) {
  write_file(*arguments.certificate, certificate(drawing.complex, drawing.input));
  report.say_written(*arguments.certificate);
  // What was rejected, the checker may not be able to read.
  const bool is_plain = arguments.file.ends_with(".lines") && arguments.reading.format.empty() &&
                        drawing.input.rejected.empty();
  const std::string file =
      arguments.file == "/dev/stdin" ? "SAME-INPUT" : line_text(arguments.file);
  const std::string of = line_text(*arguments.certificate);
  const std::string lines = is_plain ? file : of + ".lines";
  report.print("to check it: {}plumbline-verify {} {}\n",
               is_plain ? ""
                        : fmt::format("plumbline eval {}{} -o {} && ", file,
                                      reading_options(arguments.reading) +
                                          (arguments.lenient ? " --lenient" : ""),
                                      lines),
               lines, of);
}

/// The file to write: compact files are JSON.
Output output_of(const ArrangeArguments& arguments) {
  if (arguments.compact) return {arguments.output, {"json"}, arguments.format};
  return {arguments.output, complex_formats(), arguments.format};
}

/// Throws: Error BadInput for options that do not go together.
void check_options(const ArrangeArguments& arguments, std::string_view format) {
  if (arguments.grid.decimals && !arguments.safe && !is_always_rounded(format)) {
    throw Error(ErrorCode::BadInput, "of this format --decimals needs --safe", {},
                std::string(format));
  }
  if (format == "csv" && arguments.cells.size() > 1) {
    throw Error(ErrorCode::BadInput, "a .csv file holds cells of one kind: choose one by --cells");
  }
}

}  // namespace

ExitCode run(const ArrangeArguments& arguments, Report& report) {
  if (arguments.tiles > 0) return run_in_tiles(arguments, report);
  const Output output = output_of(arguments);
  if (check_outputs(arguments.file, {output, {arguments.certificate, {"certificate"}}})) {
    report.leave_standard_output();
  }
  if (output.file) check_options(arguments, format_of(output));
  const Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, drawing.input);
  const Counts counted = counts(drawing.complex, drawing.complex.vertices.size());
  const std::string signed_as = signature(drawing.complex);
  report.set_headline(counts_line(counted));
  set_input(report, drawing.input);
  set_counts(report, counted);
  report.set("signature", signed_as);
  report.set("signature2", tiles::to_text(tiles::signature2(drawing.complex)));
  report.print("{}\n", counts_line(counted));
  report.print("{}\n{}", input_line(drawing.input), rejected_lines(drawing.input));
  report.print("{}\nsignature {}\n", exactness_line(drawing.input), signed_as);
  if (output.file) {
    const ComplexFile file = complex_file(format_of(output), arguments, drawing);
    write_file(*output.file, file.content);
    if (!file.line.empty()) report.print("{}\n", file.line);
    report.say_written(*output.file);
  }
  if (arguments.certificate) write_certificate(arguments, drawing, report);
  return kAgree;
}

}  // namespace plumbline::cli
