#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engines/programs/process.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/engines/programs.hpp"

// The protocol as texts: what is sent to a program, and what its answers say.
namespace plumbline::programs {

/// How an engine failed.
struct Failure {
  enum class Kind { Error, BadTolerance, Crash, Timeout, Memory };
  Kind kind = Kind::Error;
  std::string message;  ///< after the engine's name: "says TopologyException: ..."
};

/// What became of a case: one of the two.
struct Reply {
  std::optional<files::Result> model;
  std::optional<Failure> failure;
};

/// A case as a line, its numbers in shortest decimals.
std::string case_text(const LineWork& work, std::optional<double> tolerance);

/// What `--list` printed. Throws: Error BadInput, about `program`.
Listing listing_of(const Exchange& exchange, const std::filesystem::path& program);

/// What was answered to `case_text`, or how there was no answer. Throws: Error BadInput where the
/// engine is not here or does not keep to the protocol.
Reply reply_of(const Exchange& exchange, const std::string& engine, const Limits& limits);

}  // namespace plumbline::programs
