#include "cli/tool.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include "cli/arguments.hpp"
#include "cli/memory_limit.hpp"
#include "cli/report.hpp"
#include "cli/watchdog.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// Whether a thread cannot be had since memory is limited.
bool is_thread_missing(const std::error_code& code) {
  return is_memory_limited() && code == std::errc::resource_unavailable_try_again;
}

template <class Arguments>
ExitCode run_command(const Arguments& arguments, Report& report,
                     const std::vector<Engine>& /*engines*/) {
  return run(arguments, report);
}
ExitCode run_command(const CheckArguments& arguments, Report& report,
                     const std::vector<Engine>& engines) {
  return run(arguments, report, engines);
}

/// With --json an error is a member of the summary, too.
template <class Arguments>
ExitCode run_reported(const Arguments& arguments, const std::vector<Engine>& engines) {
  Report report(arguments);
  if constexpr (std::is_base_of_v<InputArguments, Arguments>) report.set("file", arguments.file);
  try {
    const ExitCode code = run_command(arguments, report, engines);
    report.end();
    return code;
  } catch (const Error& error) {
    if (std::ferror(stdout) != 0) throw;
    report.set("error", error.what());
    report.end();
    throw;
  }
}

ExitCode parse_and_run(const std::vector<std::string>& arguments,
                       const std::vector<Engine>& engines) {
  const auto parsed = parse(arguments);
  if (const auto* notice = std::get_if<Notice>(&parsed)) {
    fmt::print(notice->is_error ? stderr : stdout, "{}", notice->text);
    flush_output();
    return notice->is_error ? kBadInput : kAgree;
  }
  const auto run_watched = [&](const auto& command) {
    for (const std::string& note : command.notes) fmt::print(stderr, "plumbline: {}\n", note);
    const Watchdog watchdog(command.limits);
    return run_reported(command, engines);
  };
  return std::visit(run_watched, std::get<Command>(parsed));
}

}  // namespace

int run(int argc, char** argv, const std::vector<Engine>& engines) {
  try {
    return parse_and_run({argv + (argc > 0 ? 1 : 0), argv + argc}, engines);
  } catch (const Error& error) {
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return error.code() == ErrorCode::Internal ? kInternal : kBadInput;
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::system_error& error) {
    if (is_thread_missing(error.code())) end_without_memory();
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    // TBB cannot start a thread: a limit of the user's, on memory or on processes.
    if (std::string_view(error.what()).starts_with("pthread_create has failed")) {
      if (is_memory_limited()) end_without_memory();
      fmt::print(stderr, "plumbline: {}\n", error.what());
      return kBadInput;
    }
    fmt::print(stderr, "plumbline: internal error: {}\n", error.what());
    return kInternal;
  }
}

}  // namespace plumbline::cli
