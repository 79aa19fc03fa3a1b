// iOverlay's JSON test files.

#include <rapidjson/document.h>
#include <rapidjson/error/en.h>

#include "cases/foreign/foreign.hpp"
#include "cases/foreign/paths.hpp"

namespace plumbline::foreign {

namespace {

/// A number as it is written, and so exact; the parser keeps it as a text.
Rational number(const rapidjson::Value& value) {
  if (!value.IsString()) throw Error(ErrorCode::BadInput, "a coordinate is not a number");
  return parse_decimal({value.GetString(), value.GetStringLength()});
}

Path path(const rapidjson::Value& value) {
  Path result;
  if (!value.IsArray()) throw Error(ErrorCode::BadInput, "a path is not a list");
  for (const rapidjson::Value& point : value.GetArray()) {
    if (!point.IsArray() || point.Size() != 2) {
      throw Error(ErrorCode::BadInput, "a point is not a pair");
    }
    result.push_back({number(point[0]), number(point[1])});
  }
  return result;
}

}  // namespace

std::vector<Case> ioverlay(std::string_view text) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseNumbersAsStringsFlag>(text.data(), text.size());
  if (document.HasParseError()) {
    throw Error(ErrorCode::BadInput,
                std::string("not JSON: ") + rapidjson::GetParseError_En(document.GetParseError()));
  }
  if (!document.IsObject()) throw Error(ErrorCode::BadInput, "not an object");
  Case one;
  bool has_paths = false;
  for (const char* member : {"subjPaths", "clipPaths", "body", "string"}) {
    const auto found = document.FindMember(member);
    if (found == document.MemberEnd()) continue;
    has_paths = true;
    if (!found->value.IsArray()) throw Error(ErrorCode::BadInput, "paths are not a list");
    for (const rapidjson::Value& value : found->value.GetArray()) {
      member == std::string_view("string") ? add_open(one.input, path(value))
                                           : add_closed(one.input, path(value));
    }
  }
  if (!has_paths) throw Error(ErrorCode::BadInput, "no paths");
  return {one};
}

}  // namespace plumbline::foreign
