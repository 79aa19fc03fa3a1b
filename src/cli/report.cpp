#include "cli/report.hpp"

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cli/outputs.hpp"
#include "cli/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline::cli {
namespace {

using JsonWriter = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

void write(JsonWriter& json, const Summary& summary);

struct ValueWriter {
  JsonWriter& json;

  void operator()(std::monostate) const { json.Null(); }
  void operator()(bool x) const { json.Bool(x); }
  void operator()(std::int64_t x) const { json.Int64(x); }
  void operator()(double x) const {
    if (!std::isfinite(x)) return (*this)(std::monostate());
    const std::string text = shortest_text(x);
    json.RawValue(text.data(), text.size(), rapidjson::kNumberType);
  }
  void operator()(const std::string& x) const {
    const std::string text = valid_utf8(x);
    json.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  }
  template <class T>
  void operator()(const std::vector<T>& list) const {
    const bool is_short = !std::is_same_v<T, Summary>;
    json.SetFormatOptions(is_short ? rapidjson::kFormatSingleLineArray : rapidjson::kFormatDefault);
    json.StartArray();
    for (const T& x : list) (*this)(x);
    json.EndArray();
    json.SetFormatOptions(rapidjson::kFormatDefault);
  }
  void operator()(const Summary& x) const { write(json, x); }
};

void write(JsonWriter& json, const Summary& summary) {
  json.StartObject();
  for (const auto& [key, value] : summary.members()) {
    json.Key(key.data(), static_cast<rapidjson::SizeType>(key.size()));
    std::visit(ValueWriter{json}, value);
  }
  json.EndObject();
}

}  // namespace

void Summary::put(std::string_view key, Value value) {
  const auto found = std::ranges::find(members_, key, &std::pair<std::string, Value>::first);
  if (found == members_.end()) {
    members_.emplace_back(key, std::move(value));
  } else {
    found->second = std::move(value);
  }
}

void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw Error(ErrorCode::BadFile, "cannot write to standard output");
  }
}

std::string json_text(const Summary& summary) {
  rapidjson::StringBuffer text;
  JsonWriter json(text);
  json.SetIndent(' ', 2);
  write(json, summary);
  return std::string(text.GetString(), text.GetSize()) + '\n';
}

void Report::print_text(const std::string& text) {
  constexpr std::size_t kLeast = 80, kMost = 100;
  const bool is_folded = ::isatty(::fileno(stream_)) != 0;
  fmt::print(stream_, "{}",
             is_folded ? folded(text, std::clamp(columns_of(stream_), kLeast, kMost)) : text);
}

std::string Report::verdict(const std::string& text, ExitCode code) const {
  if (text.find("agree") != 0 && text.find("disagree") != 0) return text;
  return first_word_coloured(text, code == kAgree ? Colour::Green : Colour::Red, stream_);
}

void Report::note_written(const std::string& file) {
  if (!is_standard_output(file)) written_.push_back(file);
}

void Report::say_written(const std::string& file) {
  note_written(file);
  if (!is_standard_output(file)) print("wrote {}\n", line_text(file));
}

void Report::end() {
  if (manners_.json) {
    if (!written_.empty()) summary_.set("written", written_);
    fmt::print(stream_, "{}", json_text(summary_));
  }
  flush_output();
}

}  // namespace plumbline::cli
