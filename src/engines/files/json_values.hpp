#pragma once

#include "read/json_tree.hpp"

namespace plumbline::files {

/// What results hold, taken from JSON. Each throws Error BadInput at the value's place.
namespace json {

/// The value, if it is of this type.
JsonValue expect(const JsonValue& value, JsonType type, const char* what);
/// The member of this name and type.
JsonValue member(const JsonValue& object, std::string_view key, JsonType type);
/// A number as the nearest double, finite.
double number(const JsonValue& value);
/// The same, or a string "p/q".
double coordinate(const JsonValue& value);
std::int64_t integer(const JsonValue& value);

}  // namespace json
}  // namespace plumbline::files
