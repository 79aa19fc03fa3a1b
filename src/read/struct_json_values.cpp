#include "read/struct_json_values.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "plumbline/error.hpp"

namespace plumbline {

void expect(const JsonValue& value, JsonType type, const char* what) {
  if (!value.is(type)) value.fail("not " + std::string(what));
}

namespace {

/// The members of a source.
constexpr std::array<std::string_view, 7> kSource{"file", "line", "column", "element",
                                                  "id",   "path", "layer"};

}  // namespace

void expect_members(const JsonValue& object, std::initializer_list<std::string_view> known) {
  const auto is_in = [](std::string_view key, const auto& names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  for (JsonValue member = object.first(); member; member = member.next()) {
    if (is_in(member.key(), known) || is_in(member.key(), kSource)) continue;
    throw Error(ErrorCode::BadInput, "a member that is not understood here", member.place(),
                printable(member.key()));
  }
}

std::string string_of(const JsonValue& value) {
  expect(value, JsonType::String, "a string");
  return valid_line(value.text());
}

bool bool_of(const JsonValue& value) {
  expect(value, JsonType::Bool, "true or false");
  return value.text() == "true";
}

std::uint32_t index_of(const JsonValue& value) {
  std::uint32_t result = 0;
  const std::string_view text = value.text();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (!value.is(JsonType::Number) || error != std::errc() || end != text.data() + text.size()) {
    value.fail("not a whole number from 0 to 2^32 - 1");
  }
  return result;
}

Number number_of(const JsonValue& value, Numbers& numbers) {
  if (!value.is(JsonType::Number) && !value.is(JsonType::String)) value.fail("not a number");
  try {
    return numbers.parse(value.text());
  } catch (const Unusable& problem) {
    value.fail(problem.reason);
  }
}

std::vector<Rational> rationals_of(const JsonValue& list, Numbers& numbers) {
  expect(list, JsonType::Array, "a list of numbers");
  std::vector<Rational> result;
  for (JsonValue v = list.first(); v; v = v.next()) {
    result.push_back(number_of(v, numbers).rational());
  }
  return result;
}

Source source_of(const JsonValue& value, const char* element,
                 const std::vector<std::string>& files) {
  const auto own_file = static_cast<std::uint32_t>(files.size() - 1);
  const Place place = value.place();
  Source result{own_file, place.line, place.column, element, valid_line(value.key()), {}};
  if (const JsonValue line = value.find("line")) {
    result = {own_file, index_of(line), 0, element, {}, {}};
  }
  if (const JsonValue file = value.find("file")) {
    result.file = index_of(file);
    if (result.file >= files.size()) file.fail("no file has this number");
  }
  if (const JsonValue column = value.find("column")) result.column = index_of(column);
  if (const JsonValue name = value.find("element")) result.element = string_of(name);
  if (const JsonValue id = value.find("id")) result.id = string_of(id);
  if (const JsonValue path = value.find("path")) result.path = string_of(path);
  if (const JsonValue layer = value.find("layer")) result.layer = string_of(layer);
  return result;
}

}  // namespace plumbline
