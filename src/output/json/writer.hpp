#pragma once

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {

/// RapidJSON's writer, with the values that our files are made of. Arrays stand on one line.
class JsonWriter : public rapidjson::PrettyWriter<rapidjson::StringBuffer> {
 public:
  JsonWriter() {
    Reset(buffer_);
    SetIndent(' ', 1);
    SetFormatOptions(rapidjson::kFormatSingleLineArray);
  }

  void text(std::string_view value) {
    const std::string utf8 = valid_utf8(value);
    String(utf8.data(), static_cast<rapidjson::SizeType>(utf8.size()));
  }
  /// The shortest decimal that reads back as the same double; an infinity as null.
  void number(double value) {
    const std::string digits = shortest_text(value);
    if (digits.find_first_of("in") != std::string::npos) {
      Null();
    } else {
      RawValue(digits.data(), digits.size(), rapidjson::kNumberType);
    }
  }
  void key(std::string_view name) {
    const std::string utf8 = valid_utf8(name);
    Key(utf8.data(), static_cast<rapidjson::SizeType>(utf8.size()));
  }
  void count(std::size_t value) { Uint64(value); }
  /// A number where the value is a decimal, else a string "p/q".
  void decimal(const Rational& value) {
    const std::string digits = exact_text(value);
    if (digits.find('/') != std::string::npos) {
      text(digits);
    } else {
      RawValue(digits.data(), digits.size(), rapidjson::kNumberType);
    }
  }
  /// A number with all its digits. Requires: the value is a decimal.
  void whole_decimal(const Rational& value) {
    const std::string digits = decimal_text(value);
    RawValue(digits.data(), digits.size(), rapidjson::kNumberType);
  }
  /// A string: a decimal or "p/q".
  void exact(const Rational& value) { text(exact_text(value)); }
  /// [x, y], exact.
  void point(const Point& p) {
    StartArray();
    exact(p.x);
    exact(p.y);
    EndArray();
  }
  /// {exact: [x, y], nearest: [x, y]}.
  void place(const Point& p) {
    const PointD rounded = nearest(p);
    StartObject();
    Key("exact");
    point(p);
    Key("nearest");
    StartArray();
    number(rounded.x);
    number(rounded.y);
    EndArray();
    EndObject();
  }
  /// The array of [count...] of a list of indices.
  template <class Range>
  void counts(const Range& values) {
    StartArray();
    for (const auto value : values) count(value);
    EndArray();
  }

  std::string take() { return std::string(buffer_.GetString(), buffer_.GetSize()) + '\n'; }

 private:
  rapidjson::StringBuffer buffer_;
};

/// The members of a source, written into the open object.
void write_source_members(JsonWriter& json, const Source& source);
/// The members "files", "rejected", "ledger".
void write_files(JsonWriter& json, const std::vector<std::string>& files);
void write_rejected(JsonWriter& json, const std::vector<Rejected>& rejected);
void write_ledger(JsonWriter& json, const std::vector<Replacement>& ledger);

/// The members that describe where a drawing's items come from: "files", "sources", "segments",
/// "rejected", "ledger". Written into the open object. Documented in docs/json.md.
void write_input(JsonWriter& json, const SegmentSet& input);

}  // namespace plumbline
