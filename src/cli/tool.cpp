#include "cli/tool.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <sstream>
#include <string_view>
#include <system_error>

#include "cli/arguments.hpp"
#include "cli/memory_limit.hpp"
#include "cli/report.hpp"
#include "cli/terminal.hpp"
#include "cli/watchdog.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// Whether a thread cannot be had since memory is limited.
bool is_thread_missing(const std::error_code& code) {
  return is_memory_limited() && code == std::errc::resource_unavailable_try_again;
}

ExitCode exit_code_of(const Error& error) {
  return error.code() == ErrorCode::Internal ? kInternal : kBadInput;
}

template <class Arguments>
ExitCode run_command(const Arguments& arguments, Report& report, const KnownEngines& /*known*/) {
  return run(arguments, report);
}
ExitCode run_command(const CheckArguments& arguments, Report& report, const KnownEngines& known) {
  return run(arguments, report, known);
}

ExitCode run_command(const EnginesArguments& arguments, Report& report, const KnownEngines& known) {
  return run(arguments, report, known);
}
ExitCode run_command(const MinimiseArguments& arguments, Report& report,
                     const KnownEngines& known) {
  return run(arguments, report, known);
}

/// With --json an error is a member of the summary, too.
template <class Arguments>
ExitCode run_reported(const Arguments& arguments, const KnownEngines& known) {
  Report report(arguments);
  if constexpr (std::is_base_of_v<InputArguments, Arguments>) report.set("file", arguments.file);
  try {
    const ExitCode code = run_command(arguments, report, known);
    report.end();
    return code;
  } catch (const Error& error) {
    if (std::ferror(stdout) != 0) throw;
    report.set("error", error.what());
    report.end();
    throw;
  }
}

/// "disagree", of what several drawings come to.
std::string outcome(ExitCode code, bool is_check) {
  if (code == kDisagree) return "disagree";
  if (code == kAgree) return is_check ? "agree" : "done";
  return "refused";
}

/// Several drawings, in a line each. What cannot be read does not stop the rest.
template <class Arguments>
ExitCode run_each(const Arguments& arguments, const KnownEngines& known) {
  constexpr bool kIsCheck = std::is_same_v<Arguments, CheckArguments>;
  Report all(arguments);
  Manners silent = arguments;
  silent.quiet = true;
  std::vector<Summary> summaries;
  std::map<std::string, std::size_t> outcomes;
  ExitCode worst = kAgree;
  for (const std::string& file : arguments.files) {
    Arguments one = arguments;
    one.file = file;
    Report report(silent);
    report.set("file", file);
    ExitCode code = kAgree;
    try {
      code = run_command(one, report, known);
      all.print("{}: {}\n", line_text(file), all.verdict(report.headline(), code));
    } catch (const Error& error) {
      code = exit_code_of(error);
      report.set("error", error.what());
      flush_output();  // in the order of the files, where both are a terminal
      tell(error.what());
    }
    report.set("exit_code", static_cast<int>(code));
    summaries.push_back(report.summary());
    ++outcomes[outcome(code, kIsCheck)];
    worst = std::max(worst, code);
  }
  std::string counted;
  for (const auto& [name, count] : outcomes) counted += fmt::format(", {} {}", count, name);
  all.print("{} drawings: {}\n", arguments.files.size(), counted.substr(2));
  all.set("files", summaries);
  all.set("exit_code", static_cast<int>(worst));
  all.end();
  return worst;
}

/// What the command asks for.
template <class Arguments>
ExitCode run_all(const Arguments& arguments, const KnownEngines& known) {
  if constexpr (std::is_base_of_v<DrawingArguments, Arguments>) {
    if (arguments.files.size() > 1) return run_each(arguments, known);
  }
  return run_reported(arguments, known);
}

/// The help with the titles of its parts as headings.
std::string with_headings(const std::string& text) {
  std::string result, line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    const bool is_title = line.ends_with(':') && !line.starts_with(' ');
    result += (is_title ? coloured(line, Colour::Bold, stdout) : line) + '\n';
  }
  return result;
}

ExitCode parse_and_run(const std::vector<std::string>& arguments, const KnownEngines& known) {
  const bool is_screen = ::isatty(STDOUT_FILENO) != 0;
  const auto parsed =
      parse(arguments, is_screen ? std::min(columns_of(stdout), kMostColumns) : kMostColumns);
  if (const auto* notice = std::get_if<Notice>(&parsed)) {
    fmt::print("{}", notice->is_help ? with_headings(notice->text) : notice->text);
    flush_output();
    return kAgree;
  }
  const auto run_watched = [&](const auto& command) {
    for (const std::string& note : command.notes) tell(note);
    const Watchdog watchdog(command.limits);
    return run_all(command, known);
  };
  return std::visit(run_watched, std::get<Command>(parsed));
}

}  // namespace

int run(int argc, char** argv, const KnownEngines& known) {
  try {
    return parse_and_run({argv + (argc > 0 ? 1 : 0), argv + argc}, known);
  } catch (const Error& error) {
    tell(error.what());
    return exit_code_of(error);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::system_error& error) {
    if (is_thread_missing(error.code())) end_without_memory();
    tell(error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    // TBB cannot start a thread: a limit of the user's, on memory or on processes.
    if (std::string_view(error.what()).starts_with("pthread_create has failed")) {
      if (is_memory_limited()) end_without_memory();
      tell(error.what());
      return kBadInput;
    }
    tell(std::string("internal error: ") + error.what());
    return kInternal;
  }
}

}  // namespace plumbline::cli
