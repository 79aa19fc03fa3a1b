#pragma once

#include <optional>
#include <string>

namespace plumbline::cli {

/// Exit codes of every command.
enum ExitCode { kAgree = 0, kDisagree = 1, kBadInput = 2, kInternal = 3 };

struct ArrangeArguments {
  std::string file;
  std::string output;
};

struct CheckArguments {
  std::string file;
  std::optional<double> radius;
  std::optional<double> tolerance;
  std::string output;
  std::string picture;
};

struct InfoArguments {
  std::string file;
};

/// Each command prints to standard output and returns its exit code. Throws: Error.
ExitCode run(const ArrangeArguments& arguments);
ExitCode run(const CheckArguments& arguments);
ExitCode run(const InfoArguments& arguments);

}  // namespace plumbline::cli
