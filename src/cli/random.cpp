#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/report.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::cli {

ExitCode run(const RandomArguments& arguments, Report& report) {
  const std::string file = arguments.output.value_or("-");
  if (check_outputs({}, {{file, {"lines"}}})) report.leave_standard_output();
  write_file(file, to_lines(random_lines(arguments.count, arguments.scaling, arguments.seed)));
  report.set("segments", arguments.count);
  report.set("seed", static_cast<std::int64_t>(arguments.seed));
  report.say_written(file);
  return kAgree;
}

}  // namespace plumbline::cli
