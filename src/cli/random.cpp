#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::cli {

ExitCode run(const RandomArguments& arguments) {
  check_outputs({}, {{arguments.output, {".lines"}}});
  const std::string rows =
      to_lines(random_lines(arguments.count, arguments.scaling, arguments.seed));
  if (!arguments.output) {
    fmt::print("{}", rows);
    return kAgree;
  }
  write_file(*arguments.output, rows);
  print_written(*arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
