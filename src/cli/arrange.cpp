#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/safe_output.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline::cli {
namespace {

/// The options with which a drawing becomes the same segments again.
std::string reading_options(const ReadOptions& reading) {
  std::string options;
  if (sgn(reading.chord_tolerance) > 0) {
    options += " --flatten " + exact_text(reading.chord_tolerance);
  }
  if (reading.angle_bound != ReadOptions().angle_bound) {
    options += " --angle " + shortest_text(reading.angle_bound);
  }
  if (!reading.join_curves) options += " --keep-curves";
  if (reading.visible_only) options += " --visible";
  return options;
}

void write_certificate(const ArrangeArguments& arguments, const Drawing& drawing) {
  write_file(*arguments.certificate, certificate(drawing.complex, drawing.input));
  print_written(*arguments.certificate);
  // What was rejected, the checker may not be able to read.
  const bool is_plain = ending(arguments.file) == ".lines" && drawing.input.rejected.empty();
  const std::string file = line_text(arguments.file);
  const std::string of = line_text(*arguments.certificate);
  const std::string lines = is_plain ? file : of + ".lines";
  fmt::print("to check it: {}plumbline-verify {} {}\n",
             is_plain ? ""
                      : fmt::format("plumbline eval {}{} -o {} && ", file,
                                    reading_options(arguments.reading) +
                                        (arguments.lenient ? " --lenient" : ""),
                                    lines),
             lines, of);
}

std::string output_of(const ArrangeArguments& arguments, const Drawing& drawing) {
  if (arguments.compact) return to_compact_json(drawing.complex, drawing.input);
  if (ending(*arguments.output) == ".json") return to_json(drawing.complex, drawing.input);
  return to_svg(drawing.complex, drawing.input.y_up);
}

/// The endings that an output may have, of which each option allows some.
std::vector<std::string> endings_of(const ArrangeArguments& arguments) {
  if (arguments.compact) return {".json"};
  std::vector<std::string> endings{".json", ".svg", ".geojson", ".wkt", ".csv", ".wkb"};
  if (arguments.safe) endings.emplace_back(".lines");
  return endings;
}

/// Whether what is written is rounded and proven. Throws: Error BadInput for options that do not go
/// together.
bool is_written_safely(const ArrangeArguments& arguments) {
  const std::string kind = arguments.output ? ending(*arguments.output) : "";
  const bool is_safe = arguments.safe || is_of_features(kind);
  if (arguments.grid.decimals && !is_safe) {
    throw Error(ErrorCode::BadInput,
                "--decimals needs --safe, or a .geojson, .wkt, .csv or .wkb file", {}, kind);
  }
  if (kind == ".csv" && arguments.cells.size() > 1) {
    throw Error(ErrorCode::BadInput, "a .csv file holds cells of one kind: choose one by --cells");
  }
  return is_safe;
}

}  // namespace

ExitCode run(const ArrangeArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, endings_of(arguments)},
                                 {arguments.certificate, {".certificate"}}});
  const bool is_safe = is_written_safely(arguments);
  const Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, drawing.input);
  fmt::print("{}\n", counts_line(drawing.complex, drawing.complex.vertices.size()));
  fmt::print("{}\n{}", input_line(drawing.input), rejected_lines(drawing.input));
  fmt::print("{}\nsignature {}\n", exactness_line(drawing.input), signature(drawing.complex));
  if (is_safe) {
    const SafeOutput output = safe_output(arguments, drawing);
    write_file(*arguments.output, output.content);
    fmt::print("{}\n", output.line);
    print_written(*arguments.output);
  } else if (arguments.output) {
    write_file(*arguments.output, output_of(arguments, drawing));
    print_written(*arguments.output);
  }
  if (arguments.certificate) write_certificate(arguments, drawing);
  return kAgree;
}

}  // namespace plumbline::cli
