// Asks svg2lines about each element that the SVG reader read, one text line at a time.

#include "engines/inters/explain/svg_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

struct Rule {
  const char* name;
  const char* explanation;
  const char* advice;
};
constexpr Rule kIntegers{"integer-division",
                         "svg2lines divides integers as integers, as all coordinates are",
                         "write coordinates with a decimal point"};
constexpr Rule kRectangles{"rect-attribute-order",
                           "svg2lines needs an attribute between y and width of a rect",
                           "read the attributes by name"};
constexpr Rule kLines{"line-attribute-order",
                      "svg2lines needs an attribute before x1, and no blank before />",
                      "read the attributes by name"};
constexpr Rule kOnePerLine{"one-element-per-line",
                           "svg2lines takes the last element of a text line only",
                           "write each element on a text line of its own"};
constexpr Rule kElements{"one-line-per-element",
                         "svg2lines knows lines and rectangles that stand on one text line, and no "
                         "transforms",
                         "read SVG as XML"};
constexpr Rule kExtent{"zero-extent", "svg2lines divides by the drawing's width and height",
                       "keep a drawing without width or height as it is"};
constexpr Rule kEvaluated{"evaluated-attributes",
                          "svg2lines evaluates attributes as expressions, with what follows them",
                          "read numbers as numbers"};

/// The error that svg2lines raises on the text; none where it reads it.
std::optional<std::string> error_on(std::string_view text) {
  try {
    svg_to_lines(text, true, Vcode(kDecimals));
    return std::nullopt;
  } catch (const StageFailure& failed) {
    return failed.failure().error;
  }
}

std::vector<std::string_view> text_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t times = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos;
       at = text.find(what, at + 1)) {
    ++times;
  }
  return times;
}

/// The value of an attribute on the text line.
std::optional<std::string_view> attribute(std::string_view line, const std::string& name) {
  const std::string start = ' ' + name + "=\"";
  const std::size_t at = line.find(start);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view rest = line.substr(at + start.size());
  return rest.substr(0, rest.find('"'));
}

/// Whether the element starts where its attributes say, so is not transformed.
bool is_in_place(std::string_view line, const std::string& element, const Segment& segment) {
  const bool is_line = element == "line";
  const auto x = attribute(line, is_line ? "x1" : "x"), y = attribute(line, is_line ? "y1" : "y");
  if (!x || !y) return false;
  try {
    return Point{parse_decimal(*x), parse_decimal(*y)} == segment.a;
  } catch (const Error&) {
    return false;
  }
}

/// Why svg2lines does not read an element as it is; none if it does.
const Rule* rule_of(std::string_view line, const Source& source, const Segment& segment) {
  const std::string tag = '<' + source.element + ' ';
  if (source.element != "line" && source.element != "rect") return &kElements;
  const bool is_last = line.find(tag, source.column) == std::string_view::npos;
  if (!is_last) return &kOnePerLine;
  const std::size_t first = line.find_first_not_of(" \t\r");
  const bool stands_first = first + 1 == source.column || count(line, tag) > 1;
  if (!stands_first || line.find("/>") == std::string_view::npos) return &kElements;
  const auto error = error_on(line);
  if (!error || error == "ZeroDivisionError") {  // the line alone may have no extent
    return is_in_place(line, source.element, segment) ? nullptr : &kElements;
  }
  if (source.element == "line") {
    const bool is_ordered = line.find("<line x1=") == std::string_view::npos &&
                            line.find(" />") == std::string_view::npos;
    return is_ordered ? &kEvaluated : &kLines;
  }
  const std::string y(attribute(line, "y").value_or(""));
  return line.find(" y=\"" + y + "\" width=") == std::string_view::npos ? &kEvaluated
                                                                        : &kRectangles;
}

bool has_integers_only(std::string_view line) {
  for (const char* name : {"x1", "y1", "x2", "y2", "x", "y", "width", "height"}) {
    if (const auto value = attribute(line, name);
        value && value->find_first_of(".eE") != std::string_view::npos) {
      return false;
    }
  }
  return true;
}

Explained explained(const Rule& rule, std::vector<SegmentId> segments) {
  Explained result;
  result.finding.kind = CellKind::Complex;
  result.finding.disagreement = Disagreement::Missing;
  result.finding.message = fmt::format("svg2lines would misread {} segment{}", segments.size(),
                                       segments.size() == 1 ? "" : "s");
  result.finding.segments = std::move(segments);
  result.cause = {kParse, 0, rule.name, rule.explanation, rule.advice, true};
  return result;
}

}  // namespace

std::vector<Explained> svg_to_lines_findings(std::string_view svg, const SegmentSet& input) {
  const std::vector<std::string_view> lines = text_lines(svg);
  std::map<std::string, std::pair<const Rule*, std::vector<SegmentId>>> by_rule;
  const auto add = [&](const Rule& rule, SegmentId segment) {
    by_rule[rule.name].first = &rule;
    by_rule[rule.name].second.push_back(segment);
  };
  std::vector<SegmentId> read;
  bool are_integers = true;
  std::optional<SourceId> judged;
  const Rule* rule = nullptr;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const SourceId id = input.segment_source[i];
    const Source source = input.sources[id];
    const std::string_view line =
        source.line >= 1 && source.line <= lines.size() ? lines[source.line - 1] : "";
    if (judged != id) rule = rule_of(line, source, input.segments[i]);  // by its first segment
    judged = id;
    if (rule) {
      add(*rule, SegmentId(i));
      continue;
    }
    read.emplace_back(i);
    are_integers = are_integers && has_integers_only(line);
  }
  const bool has_extent = error_on(svg) != "ZeroDivisionError";
  for (const SegmentId s : read) {
    if (!has_extent) add(kExtent, s);
    if (has_extent && are_integers) add(kIntegers, s);
  }
  std::vector<Explained> result;
  for (auto& [name, found] : by_rule) {
    result.push_back(explained(*found.first, std::move(found.second)));
  }
  return result;
}

}  // namespace plumbline::inters
