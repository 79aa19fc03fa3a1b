#include "engines/programs/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

#include "engines/files/json_values.hpp"
#include "engines/files/readers.hpp"
#include "plumbline/error.hpp"
#include "plumbline/number.hpp"
#include "read/byte_stream.hpp"
#include "read/json_tree.hpp"

namespace plumbline::programs {
namespace {

constexpr int kNotHere = 3;  // the exit code of programs whose engine is not installed
constexpr const char* kCase = "17";
constexpr const char* kBadTolerance = "BadTolerance";  // the class of errors about a case's own
constexpr std::size_t kMostQuoted = 200;               // bytes of what a program said

using files::json::expect;
using files::json::member;

/// In one line, and not too long.
std::string short_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  text = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
  const std::string line = line_text(valid_line(text.substr(0, kMostQuoted)));
  return text.size() > kMostQuoted ? line + "..." : line;
}

std::string last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  const std::size_t before = text.rfind('\n');
  return short_line(before == std::string_view::npos ? text : text.substr(before + 1));
}

/// Words by which virtual machines and libraries say that memory ran out.
bool tells_of_memory(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<std::string_view, 6> kWords{"memoryerror",      "bad_alloc",
                                                   "outofmemory",      "heap out of memory",
                                                   "memory exhausted", "cannot allocate memory"};
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

[[noreturn]] void refuse(const std::string& engine, const std::string& why,
                         const std::string& said) {
  throw Error(ErrorCode::BadInput, engine + " does not keep to the protocol of engines: " + why +
                                       ": " +
                                       (said.empty() ? "it said nothing" : short_line(said)));
}

[[noreturn]] void say_not_here(const std::string& engine, const std::string& said) {
  const std::string reason = last_line(said);
  throw Error(ErrorCode::BadInput, "the engine " + engine + " is not here: " +
                                       (reason.empty() ? "it did not say why" : reason));
}

std::string text_member(const JsonValue& object, std::string_view key) {
  return std::string(member(object, key, JsonType::String).text());
}

Configuration configuration_of(const JsonValue& value) {
  expect(value, JsonType::Object, "a configuration, an object");
  Configuration result;
  result.name = text_member(value, "name");
  result.title = text_member(value, "title");
  result.source = text_member(value, "source");
  const JsonValue tolerance = member(value, "tolerance", JsonType::Object);
  const std::string kind = text_member(tolerance, "kind");
  constexpr std::array kKinds{ToleranceKind::None, ToleranceKind::Grid, ToleranceKind::Snap,
                              ToleranceKind::Relative};
  const auto named = std::ranges::find(kKinds, kind, [](auto k) { return to_text(k); });
  if (named == kKinds.end()) tolerance.fail("a tolerance is none, grid, snap or relative");
  result.tolerance_kind = *named;
  if (*named == ToleranceKind::None) return result;
  result.tolerance = files::json::number(member(tolerance, "value", JsonType::Number));
  if (result.tolerance < 0) tolerance.fail("a negative tolerance");
  return result;
}

Listing listing_of(const JsonValue& root) {
  expect(root, JsonType::Object, "an object");
  Listing result;
  result.engine = text_member(root, "engine");
  result.title = text_member(root, "title");
  result.version = text_member(root, "version");
  result.algorithm = text_member(root, "algorithm");
  result.licence = text_member(root, "licence");
  const JsonValue input = root.find("input");
  result.takes_rings = input && input.text() == "rings";
  const JsonValue configurations = member(root, "configurations", JsonType::Array);
  for (JsonValue item = configurations.first(); item; item = item.next()) {
    result.configurations.push_back(configuration_of(item));
  }
  if (result.configurations.empty()) configurations.fail("an engine without configurations");
  return result;
}

/// "TopologyException: side location conflict"; many messages begin with their class.
std::string error_text(const JsonValue& error) {
  expect(error, JsonType::Object, "an error, an object");
  const std::string kind = text_member(error, "class"), message = text_member(error, "message");
  if (message.empty() || message.starts_with(kind)) return message.empty() ? kind : message;
  return kind + ": " + message;
}

std::string memory_text(const Limits& limits) {
  return fmt::format("needs more memory than {} GB",
                     shortest_text(static_cast<double>(limits.bytes) / kGigabyte));
}

Reply failed(Failure::Kind kind, std::string message) {
  return {{}, Failure{kind, std::move(message)}};
}

/// What it said, after a colon.
std::string saying(const std::string& words) { return words.empty() ? words : ": " + words; }

Reply answered(const JsonValue& root, const std::string& engine, const Limits& limits) {
  expect(root, JsonType::Object, "an object");
  const JsonValue number = root.find("case");
  if (!number || number.text() != kCase) root.fail(std::string("case ") + kCase + " was asked");
  if (const JsonValue error = root.find("error")) {
    const std::string text = error_text(error);
    if (tells_of_memory(text)) {
      return failed(Failure::Kind::Memory, memory_text(limits) + saying(short_line(text)));
    }
    const bool is_of_tolerance = error.find("class").text() == kBadTolerance;
    return failed(is_of_tolerance ? Failure::Kind::BadTolerance : Failure::Kind::Error,
                  "says " + short_line(text));
  }
  return {files::read_lar(member(root, "model", JsonType::Object), engine), {}};
}

/// The program ended, and there is no answer.
Reply ended(const Exchange& exchange, const Limits& limits) {
  const std::string last = last_line(exchange.said);
  const bool is_signal = exchange.ending == Exchange::Ending::Signalled;
  // The kernel ends so what takes the machine's memory.
  const bool is_killed = is_signal && exchange.code == SIGKILL;
  if (is_killed || tells_of_memory(exchange.said)) {
    return failed(Failure::Kind::Memory,
                  memory_text(limits) + saying(last.empty() && is_killed ? "SIGKILL" : last));
  }
  if (is_signal) {
    const char* const name = ::sigabbrev_np(exchange.code);
    return failed(Failure::Kind::Crash,
                  "crashed: SIG" + std::string(name == nullptr ? "NAL" : name) + saying(last));
  }
  return failed(
      Failure::Kind::Crash,
      fmt::format("ended with code {} instead of answering", exchange.code) + saying(last));
}

}  // namespace

std::string to_text(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::None:
      return "none";
    case ToleranceKind::Grid:
      return "grid";
    case ToleranceKind::Snap:
      return "snap";
    case ToleranceKind::Relative:
      return "relative";
  }
  return "unknown";
}

std::string case_text(const LineWork& work, std::optional<double> tolerance) {
  std::string text = std::string("{\"case\": ") + kCase;
  if (tolerance) text += ", \"tolerance\": " + shortest_text(*tolerance);
  text += ", \"segments\": [";
  bool is_first = true;
  for (const auto& [a, b] : work.segments) {
    text += is_first ? "[" : ", [";
    is_first = false;
    text += shortest_text(a.x) + ", " + shortest_text(a.y) + ", " + shortest_text(b.x) + ", " +
            shortest_text(b.y) + ']';
  }
  return text + "]}\n";
}

Listing listing_of(const Exchange& exchange, const std::filesystem::path& program) {
  const std::string name = program.string();
  if (exchange.ending == Exchange::Ending::Exited && exchange.code == kNotHere) {
    say_not_here(name, exchange.said);
  }
  if (exchange.ending == Exchange::Ending::TimedOut) refuse(name, "--list does not end", "");
  if (exchange.ending != Exchange::Ending::Answered) {
    refuse(name, "--list failed", exchange.said.empty() ? exchange.answer : exchange.said);
  }
  try {
    ByteStream bytes(exchange.answer, {name, 1, 1});
    const JsonTree tree(bytes);
    return listing_of(tree.root());
  } catch (const Error& error) {
    refuse(name, "--list: " + error.message(), exchange.answer);
  }
}

Reply reply_of(const Exchange& exchange, const std::string& engine, const Limits& limits) {
  switch (exchange.ending) {
    case Exchange::Ending::TimedOut:
      return failed(Failure::Kind::Timeout,
                    "gave no answer within " + shortest_text(limits.seconds) + " s");
    case Exchange::Ending::Exited:
      if (exchange.code == kNotHere) say_not_here(engine, exchange.said);
      [[fallthrough]];
    case Exchange::Ending::Signalled:
      return ended(exchange, limits);
    case Exchange::Ending::Answered:
      break;
  }
  try {
    ByteStream bytes(exchange.answer, {engine, 1, 1});
    const JsonTree tree(bytes);
    return answered(tree.root(), engine, limits);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadInput) throw;
    refuse(engine, error.message(), exchange.answer);
  }
}

}  // namespace plumbline::programs
