#pragma once

#include <rapidjson/document.h>
#include <rapidjson/filereadstream.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "plumbline/engines/inters.hpp"

/// A file of tests/data.
inline rapidjson::Document recorded(const std::string& name) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen((PLUMBLINE_TEST_DATA "/" + name).c_str(), "rb"), &std::fclose);
  if (!file) throw std::runtime_error("no file " + name);
  std::vector<char> buffer(1U << 16U);
  rapidjson::FileReadStream stream(file.get(), buffer.data(), buffer.size());
  rapidjson::Document document;
  document.ParseStream<rapidjson::kParseFullPrecisionFlag>(stream);
  if (document.HasParseError()) throw std::runtime_error("malformed " + name);
  return document;
}

inline plumbline::PointD recorded_point(const rapidjson::Value& value) {
  return {value[0].GetDouble(), value[1].GetDouble()};
}

inline std::vector<plumbline::SegmentD> recorded_lines(const rapidjson::Value& value) {
  std::vector<plumbline::SegmentD> lines;
  for (const auto& line : value.GetArray()) {
    lines.push_back({recorded_point(line[0]), recorded_point(line[1])});
  }
  return lines;
}

/// Whether `value` is as expected; it may have members that the expected one has not.
inline bool is_as_recorded(const rapidjson::Value& value, const rapidjson::Value& expected) {
  if (!expected.IsObject()) return value == expected;
  if (!value.IsObject()) return false;
  return std::all_of(expected.MemberBegin(), expected.MemberEnd(), [&](const auto& member) {
    const auto found = value.FindMember(member.name);
    return found != value.MemberEnd() && is_as_recorded(found->value, member.value);
  });
}

/// The numbers in a value, depth first, members by name, each array led by its size.
inline void append_numbers(const rapidjson::Value& value, std::vector<double>& numbers) {
  if (value.IsNumber()) numbers.push_back(value.GetDouble() + 0.0);
  if (value.IsArray()) {
    numbers.push_back(value.Size());
    for (const auto& item : value.GetArray()) append_numbers(item, numbers);
  }
  if (value.IsObject()) {
    std::map<std::string, const rapidjson::Value*> members;
    for (const auto& member : value.GetObject()) members[member.name.GetString()] = &member.value;
    for (const auto& [name, member] : members) append_numbers(*member, numbers);
  }
}

/// FNV-1a over the numbers' bytes, little end first, in hexadecimal digits.
inline std::string digest(const rapidjson::Value& value) {
  std::vector<double> numbers;
  append_numbers(value, numbers);
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const double number : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      hash = (hash ^ ((bits >> shift) & 0xffU)) * 0x100000001b3U;
    }
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}
