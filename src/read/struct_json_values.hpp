#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "plumbline/geometry.hpp"
#include "read/attribute.hpp"
#include "read/json_tree.hpp"

namespace plumbline {

/// What the values of a structure's JSON have to be. Each throws Error BadInput at the value's
/// place where it is something else.
void expect(const JsonValue& value, JsonType type, const char* what);
/// The members that an object may have beside those of a source.
void expect_members(const JsonValue& object, std::initializer_list<std::string_view> known);
std::string string_of(const JsonValue& value);
std::uint32_t index_of(const JsonValue& value);
bool bool_of(const JsonValue& value);
/// A decimal, or a string with one or with "p/q".
Number number_of(const JsonValue& value, Numbers& numbers);
std::vector<Rational> rationals_of(const JsonValue& list, Numbers& numbers);

/// The members of a source (`file`, `line`, `column`, `element`, `id`, `path`, `layer`), of which
/// each may be missing. Without a line: the place of the value itself in the last of the files,
/// under its id or the name of its definition.
Source source_of(const JsonValue& value, const char* element,
                 const std::vector<std::string>& files);

}  // namespace plumbline
