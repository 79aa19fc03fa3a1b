#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands.hpp"

namespace plumbline::cli {

/// What a command tells, by key, in order: for --json.
class Summary {
 public:
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                             std::vector<double>, std::vector<std::string>, std::vector<Summary>>;

  /// Replaces what the key has.
  template <class T>
  void set(std::string_view key, const T& x) {
    if constexpr (std::integral<T> && !std::is_same_v<T, bool>) {
      put(key, static_cast<std::int64_t>(x));
    } else if constexpr (std::is_convertible_v<T, std::string_view>) {
      put(key, std::string(x));
    } else {
      put(key, x);
    }
  }
  const std::vector<std::pair<std::string, Value>>& members() const { return members_; }

 private:
  void put(std::string_view key, Value value);

  std::vector<std::pair<std::string, Value>> members_;
};

/// What was printed is written, or that fails. Throws: Error BadFile.
void flush_output();

/// One JSON object, ended by a line break.
std::string json_text(const Summary& summary);

/// What a command has to say, as its manners are: text while it works, or a summary in the end. On
/// standard output, or on standard error where data go to the former.
class Report {
 public:
  explicit Report(const Manners& manners) : manners_(manners) {}

  /// Text, which --json and --quiet leave out; on a terminal in lines of at most 100 columns.
  template <class... T>
  void print(fmt::format_string<T...> format, T&&... arguments) {
    if (!manners_.json && !manners_.quiet) {
      print_text(fmt::format(format, std::forward<T>(arguments)...));
    }
  }
  /// A member of the summary.
  template <class T>
  void set(std::string_view key, const T& x) {
    summary_.set(key, x);
  }
  /// The drawing in one line, which is all that is said where there are several.
  void set_headline(std::string line) { headline_ = std::move(line); }
  /// The text with a first word that says by its colour whether it is good news.
  std::string verdict(const std::string& text, ExitCode code) const;
  /// Data go to standard output.
  void leave_standard_output() { stream_ = stderr; }
  /// Notes, or also says, that the file is written.
  void note_written(const std::string& file);
  void say_written(const std::string& file);
  /// The summary, for --json, and flushes. Throws: Error BadFile where that fails.
  void end();

  const Summary& summary() const { return summary_; }
  const std::string& headline() const { return headline_; }

 private:
  void print_text(const std::string& text);

  Manners manners_;
  std::FILE* stream_ = stdout;
  Summary summary_;
  std::vector<std::string> written_;
  std::string headline_;
};

}  // namespace plumbline::cli
