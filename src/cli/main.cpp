#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "cli/arguments.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

ExitCode parse_and_run(const std::vector<std::string>& arguments) {
  const auto parsed = parse(arguments);
  if (const auto* told = std::get_if<Told>(&parsed)) {
    fmt::print(told->is_error ? stderr : stdout, "{}", told->text);
    return told->is_error ? kBadInput : kAgree;
  }
  return std::visit([](const auto& command) { return run(command); }, std::get<Command>(parsed));
}

ExitCode guarded(int argc, char** argv) {
  try {
    const ExitCode code = parse_and_run({argv + (argc > 0 ? 1 : 0), argv + argc});
    if (std::fflush(stdout) != 0)
      throw Error(ErrorCode::BadFile, "cannot write to standard output");
    return code;
  } catch (const Error& error) {
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return error.code() == ErrorCode::Internal ? kInternal : kBadInput;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "plumbline: out of memory\n");
    return kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumbline: internal error: {}\n", error.what());
    return kInternal;
  }
}

}  // namespace
}  // namespace plumbline::cli

int main(int argc, char** argv) { return plumbline::cli::guarded(argc, argv); }
