// The table of output formats. Who writes one of complexes: `complex_writers` in complex_file.cpp.

#include "cli/formats.hpp"

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr bool kComplexes = true, kFeatures = true;

template <class Test>
std::vector<std::string_view> names_where(Test test) {
  std::vector<std::string_view> names;
  for (const Format& format : formats()) {
    if (test(format)) names.push_back(format.name);
  }
  return names;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table{
      {"json", {".json"}, kComplexes},
      {"svg", {".svg"}, kComplexes},
      {"geojson", {".geojson"}, kComplexes, kFeatures},
      {"topojson", {".topojson"}, kComplexes, kFeatures},
      {"dxf", {".dxf"}, kComplexes, kFeatures},
      {"wkt", {".wkt"}, kComplexes, kFeatures},
      {"csv", {".csv"}, kComplexes, kFeatures},
      {"wkb", {".wkb"}, kComplexes, kFeatures},
      {"obj", {".obj"}, kComplexes},
      {"lar", {".lar.json"}, kComplexes},
      {"lines", {".lines"}, kComplexes},
      {"html", {".html", ".htm"}},
      {"certificate", {".certificate"}},
      {"markdown", {".md"}},
  };
  return table;
}

std::vector<std::string_view> feature_formats() {
  return names_where([](const Format& format) { return format.of_features; });
}

std::vector<std::string_view> complex_formats() {
  return names_where([](const Format& format) { return format.of_complexes; });
}

std::vector<std::string_view> finding_formats() {
  std::vector<std::string_view> names = feature_formats();
  names.emplace_back("json");
  return names;
}

std::vector<std::string_view> rooms_formats() {
  std::vector<std::string_view> names = feature_formats();
  names.insert(names.end(), {"json", "svg", "html"});
  return names;
}

std::vector<std::string_view> repair_formats() {
  std::vector<std::string_view> names{"lines"};
  const std::vector<std::string_view> features = feature_formats();
  names.insert(names.end(), features.begin(), features.end());
  names.emplace_back("svg");
  return names;
}

const Format& format_named(std::string_view name) {
  const auto found = std::ranges::find(formats(), name, &Format::name);
  ensure(found != formats().end(), "the format is in the table");
  return *found;
}

std::optional<std::string_view> format_by_ending(std::string_view file,
                                                 const std::vector<std::string_view>& names) {
  std::string text(file);
  std::ranges::transform(text, text.begin(), lower);
  std::optional<std::string_view> result;
  std::size_t longest = 0;
  for (const std::string_view name : names) {
    for (const std::string_view ending : format_named(name).endings) {
      if (ending.size() <= longest || !text.ends_with(ending)) continue;
      result = name;
      longest = ending.size();
    }
  }
  return result;
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += names[i];
  }
  return text;
}

std::string listed_endings(const std::vector<std::string_view>& names) {
  std::vector<std::string_view> endings;
  for (const std::string_view name : names) {
    const auto& of_name = format_named(name).endings;
    endings.insert(endings.end(), of_name.begin(), of_name.end());
  }
  return listed(endings);
}

}  // namespace plumbline::cli
