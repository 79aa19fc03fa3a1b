#pragma once

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <string>
#include <string_view>

#include "read/byte_stream.hpp"

namespace plumbline {

enum class JsonScalar { Null, Bool, Number, String };

/// Limits of a JSON text: how deep it nests, and how long a text or number in it is.
inline constexpr std::size_t kMaxJsonDepth = 1'000'000;
inline constexpr std::uint64_t kMaxJsonToken = std::uint64_t{1} << 28U;

// NOLINTBEGIN(readability-identifier-naming): the names are those that RapidJSON asks for.

/// RapidJSON's concept of a stream.
class JsonStream {
 public:
  using Ch = char;
  explicit JsonStream(ByteStream& bytes) : bytes_(bytes) {}
  Ch Peek() const { return bytes_.peek(); }
  Ch Take() { return bytes_.take(); }
  std::size_t Tell() const { return bytes_.offset(); }
  // For parsing in place, which no one asks for.
  Ch* PutBegin() { return nullptr; }
  void Put(Ch) {}
  void Flush() {}
  std::size_t PutEnd(Ch*) { return 0; }

 private:
  ByteStream& bytes_;
};

/// RapidJSON's events as those of a Target; false stops.
template <class Target>
class JsonEvents {
 public:
  JsonEvents(ByteStream& bytes, Target& target) : bytes_(bytes), target_(target) {}

  bool Null() { return scalar(JsonScalar::Null, "null"); }
  bool Bool(bool value) { return scalar(JsonScalar::Bool, value ? "true" : "false"); }
  bool RawNumber(const char* text, rapidjson::SizeType length, bool) {
    return scalar(JsonScalar::Number, {text, length});
  }
  bool String(const char* text, rapidjson::SizeType length, bool) {
    return scalar(JsonScalar::String, {text, length});
  }
  bool Key(const char* text, rapidjson::SizeType length, bool) {
    bytes_.expect_within(kMaxJsonToken);
    target_.key({text, length});
    return !target_.done();
  }
  bool StartObject() {
    enter();
    target_.open_object();
    return !target_.done();
  }
  bool EndObject(rapidjson::SizeType) {
    leave();
    target_.close_object();
    return !target_.done();
  }
  bool StartArray() {
    enter();
    target_.open_array();
    return !target_.done();
  }
  bool EndArray(rapidjson::SizeType) {
    leave();
    target_.close_array();
    return !target_.done();
  }
  // Numbers come as text only.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }
  // NOLINTEND(readability-identifier-naming)

 private:
  bool scalar(JsonScalar kind, std::string_view text) {
    bytes_.expect_within(kMaxJsonToken);
    target_.scalar(kind, text);
    return !target_.done();
  }
  void enter() {
    bytes_.expect_within(kMaxJsonToken);
    if (++depth_ > kMaxJsonDepth) {
      throw Error(ErrorCode::Limit,
                  "JSON nested more than " + std::to_string(kMaxJsonDepth) + " deep",
                  bytes_.place());
    }
  }
  void leave() {
    bytes_.expect_within(kMaxJsonToken);
    --depth_;
  }

  ByteStream& bytes_;
  Target& target_;
  std::size_t depth_ = 0;
};

/// Tells a JSON text (RFC 8259) to the target, value by value: scalar(kind, text), numbers as they
/// are written, and key(text), the stream standing behind them; open_object(), close_object(),
/// open_array(), close_array(), the stream standing before the bracket. Stops where the target is
/// done(). No recursion. Throws: Error BadInput for anything else, with its place; Limit; what the
/// target throws.
template <class Target>
void parse_json(ByteStream& bytes, Target& target) {
  constexpr unsigned kFlags = rapidjson::kParseIterativeFlag |
                              rapidjson::kParseNumbersAsStringsFlag |
                              rapidjson::kParseValidateEncodingFlag;
  bytes.expect_within(kMaxJsonToken);
  JsonStream stream(bytes);
  JsonEvents<Target> events(bytes, target);
  rapidjson::Reader reader;
  const rapidjson::ParseResult result = reader.Parse<kFlags>(stream, events);
  if (target.done()) return;
  if (result.IsError()) {
    bytes.fail(std::string("not JSON: ") + rapidjson::GetParseError_En(result.Code()));
  }
  if (!bytes.at_end()) bytes.fail("not JSON: a zero byte");
}

}  // namespace plumbline
