#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/load.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"

namespace plumbline::cli {

ExitCode run(const ArrangeArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json", ".svg"}}});
  const Drawing drawing = load(arguments);
  fmt::print("{}\n", counts_line(drawing.complex, drawing.complex.vertices.size()));
  fmt::print("{} segments, {} rejected\n{}", drawing.input.segments.size(),
             drawing.input.rejected.size(), rejected_lines(drawing.input));
  fmt::print("{}\nsignature {}\n", exactness_line(drawing.input), signature(drawing.complex));
  if (!arguments.output) return kAgree;
  write_file(*arguments.output, ending(*arguments.output) == ".json"
                                    ? to_json(drawing.complex, drawing.input)
                                    : to_svg(drawing.complex, drawing.input.y_up));
  fmt::print("wrote {}\n", *arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
