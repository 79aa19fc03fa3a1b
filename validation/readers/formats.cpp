// What the readers make of files: per file one line of JSON on standard output.
// Usage: plumbline_formats FILE...

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "plumbline/plumbline.hpp"

using namespace plumbline;

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

double length(const SegmentSet& set) {
  double sum = 0;
  for (const Segment& s : set.segments) sum += nearest_sqrt(squared_distance(s.a, s.b));
  return sum;
}

std::string reasons(const SegmentSet& set) {
  std::map<std::string, std::size_t> counts;
  for (const Rejected& item : set.rejected) ++counts[item.source.element + ": " + item.reason];
  for (const Remark& item : set.remarks) ++counts[item.source.element + ": " + item.what];
  std::string text;
  for (const auto& [reason, count] : counts) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", quoted(reason), count);
  }
  return "{" + text + "}";
}

std::string row(const std::string& file) {
  try {
    const SegmentSet set = evaluate(read(file));
    return fmt::format(R"("segments": {}, "length": {}, "rejected": {})", set.segments.size(),
                       length(set), reasons(set));
  } catch (const Error& error) {
    const Place& place = error.place();
    return fmt::format(R"("error": {}, "line": {}, "column": {})", quoted(error.message()),
                       place.line, place.column);
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    fmt::print("{{\"file\": {}, {}}}\n", quoted(argv[i]), row(argv[i]));
  }
}
