#include "engines/files/json_values.hpp"

#include <charconv>
#include <cmath>

#include "plumbline/error.hpp"
#include "plumbline/number.hpp"
#include "read/byte_stream.hpp"

namespace plumbline::files::json {

JsonValue expect(const JsonValue& value, JsonType type, const char* what) {
  if (!value.is(type)) value.fail(std::string("expected ") + what);
  return value;
}

JsonValue member(const JsonValue& object, std::string_view key, JsonType type) {
  const JsonValue value = object.find(key);
  if (!value) {
    throw Error(ErrorCode::BadInput, "a member is missing", object.place(), printable(key));
  }
  if (!value.is(type)) value.fail("member " + printable(key) + " is of another type");
  return value;
}

double number(const JsonValue& value) {
  return coordinate(expect(value, JsonType::Number, "a number"));
}

double coordinate(const JsonValue& value) {
  const bool is_fraction =
      value.is(JsonType::String) && value.text().find('/') != std::string_view::npos;
  if (!is_fraction) expect(value, JsonType::Number, "a number");
  double result = 0;
  try {
    result = nearest_double(parse_number(value.text()));
  } catch (const Error& error) {
    value.fail(error.message());
  }
  if (!std::isfinite(result)) value.fail("a number beyond the largest double");
  return result;
}

std::int64_t integer(const JsonValue& value) {
  expect(value, JsonType::Number, "an integer");
  const std::string_view text = value.text();
  std::int64_t result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size()) value.fail("expected an integer");
  return result;
}

}  // namespace plumbline::files::json
