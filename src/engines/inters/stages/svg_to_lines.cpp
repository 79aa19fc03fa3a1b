// Lines and rectangles from SVG text by pattern, and the map to the unit square, section 4
// (svg2lines). The original evaluates the attributes as Python expressions; here they are numbers
// or nothing. Numbers keep Python 2's two kinds, because integers divide as integers (S1).

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "engines/inters/stages/fail.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// An integer or a float, with the arithmetic of Python 2.
struct Number {
  double value = 0;
  bool is_integer = false;

  friend Number operator+(Number s, Number t) { return {s.value + t.value, both(s, t)}; }
  friend Number operator-(Number s, Number t) { return {s.value - t.value, both(s, t)}; }
  friend Number operator*(Number s, Number t) { return {s.value * t.value, both(s, t)}; }
  friend Number operator/(Number s, Number t) {
    if (t.value == 0) fail("ZeroDivisionError", "division by zero", "svg2lines");
    const double quotient = s.value / t.value;
    return {both(s, t) ? std::floor(quotient) : quotient, both(s, t)};
  }
  friend bool operator<(Number s, Number t) { return s.value < t.value; }

 private:
  static bool both(Number s, Number t) { return s.is_integer && t.is_integer; }
};

constexpr Number integer(int value) { return {static_cast<double>(value), true}; }

struct Point2 {
  Number x, y;
};
using Line = std::array<Point2, 2>;

[[noreturn]] void fail_syntax() { fail("SyntaxError", "not a list of numbers", "svg2lines"); }

std::string_view stripped(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\n\v\f\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

Number number(std::string_view text) {
  text = stripped(text);
  Number result;
  result.is_integer = text.find_first_of(".eE") == std::string_view::npos;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.value);
  if (error != std::errc{} || end != text.data() + text.size()) fail_syntax();
  if (!std::isfinite(result.value)) fail_syntax();
  return result;
}

/// The text between the literals, at least one character each; literals are matched as far right as
/// possible, as greedy patterns do.
template <std::size_t n>
std::optional<std::array<std::string_view, n - 1>> between_last(
    std::string_view text, const std::array<std::string_view, n>& literals) {
  std::array<std::string_view, n - 1> parts;
  std::size_t end = text.size();
  for (std::size_t i = n; i-- > 0;) {
    const std::string_view literal = literals[i];
    if (end < literal.size()) return std::nullopt;
    const std::size_t at = text.rfind(literal, end - literal.size());
    if (at == std::string_view::npos) return std::nullopt;
    if (i + 1 < n) parts[i] = text.substr(at + literal.size(), end + 1 - (at + literal.size()));
    if (at == 0 && i > 0) return std::nullopt;
    end = at - 1;  // one character at least stands before the next literal
  }
  return parts;
}

/// The text between the literals, matched as far left as possible, as lazy patterns do; `least` is
/// the least number of characters between.
template <std::size_t n>
std::optional<std::array<std::string_view, n - 1>> between_first(
    std::string_view text, const std::array<std::string_view, n>& literals,
    const std::array<std::size_t, n - 1>& least) {
  std::array<std::string_view, n - 1> parts;
  std::size_t start = text.find(literals[0]);
  if (start == std::string_view::npos) return std::nullopt;
  start += literals[0].size();
  for (std::size_t i = 1; i < n; ++i) {
    const std::size_t at = text.find(literals[i], start + least[i - 1]);
    if (at == std::string_view::npos) return std::nullopt;
    parts[i - 1] = text.substr(start, at - start);
    start = at + literals[i].size();
  }
  return parts;
}

std::vector<std::string_view> text_lines(std::string_view text) {
  std::vector<std::string_view> result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    result.push_back(stripped(line));
  }
  return result;
}

/// The elements of a kind whose text matches. Where there are some and none matches, the original
/// evaluates an empty text.
std::vector<Line> line_elements(std::span<const std::string_view> lines) {
  std::vector<Line> result;
  bool has_some = false;
  for (const std::string_view line : lines) {
    if (!line.starts_with("<line ")) continue;
    has_some = true;
    const auto parts =
        between_last<6>(line, {"<line ", "\" x1=\"", "\" y1=\"", "\" x2=\"", "\" y2=\"", "\"/>"});
    if (!parts) continue;
    const auto& [before, x1, y1, x2, y2] = *parts;
    result.push_back({{{number(x1), number(y1)}, {number(x2), number(y2)}}});
  }
  if (has_some && result.empty()) fail_syntax();
  return result;
}

std::vector<Line> rectangle_diagonals(std::span<const std::string_view> lines) {
  std::vector<Line> result;
  bool has_some = false;
  for (const std::string_view line : lines) {
    if (!line.starts_with("<rect ")) continue;
    has_some = true;
    const auto parts = between_first<6>(
        line, {"<rect x=\"", "\" y=\"", "\" ", " width=\"", "\" height=\"", "\"/>"},
        {1, 1, 0, 1, 1});
    if (!parts) continue;
    const auto& [x, y, between, width, height] = *parts;
    const Point2 corner{number(x), number(y)};
    result.push_back({{corner, {corner.x + number(width), corner.y + number(height)}}});
  }
  if (has_some && result.empty()) fail_syntax();
  return result;
}

std::vector<Line> sides(const Line& diagonal) {
  const auto& [p, q] = diagonal;
  const Point2 right{q.x, p.y}, left{p.x, q.y};
  return {{{p, right}}, {{right, q}}, {{q, left}}, {{left, p}}};
}

/// A box: low and high corner.
Line box_of(std::span<const Line> lines) {
  Line box{lines[0][0], lines[0][0]};
  for (const Line& line : lines) {
    for (const Point2& p : line) {
      box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y)};
      box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y)};
    }
  }
  return box;
}

/// Window to viewport, isomorphic: the longer side becomes 1, y is turned upwards with the top
/// at 1.
std::vector<SegmentD> to_unit_square(std::span<const Line> lines, const Vcode& vcode) {
  if (lines.empty()) {
    fail("TypeError", "reduce() of empty sequence with no initial value", "svg2lines");
  }
  const Line box = box_of(lines);
  const Number width = box[1].x - box[0].x, height = box[1].y - box[0].y;
  const bool is_wide = integer(1) < width / height;
  const Number ratio = is_wide ? height / width : width / height;
  const Number half{0.5, false};
  const Number shorter = (half + ratio / integer(2)) - (half - ratio / integer(2));
  const Number wide = is_wide ? integer(1) : shorter;
  const Number high = is_wide ? shorter : integer(1);
  const auto mapped = [&](const Point2& p) {
    const Number x = ((p.x - box[0].x) * wide) / width;
    const Number y = ((p.y - box[0].y) * high) / (box[0].y - box[1].y) + integer(1);
    return vcode.quantised(PointD{x.value, y.value});
  };
  std::vector<SegmentD> result;
  for (const Line& line : lines) result.push_back({mapped(line[0]), mapped(line[1])});
  return result;
}

}  // namespace

std::vector<SegmentD> svg_to_lines(std::string_view svg, bool rectangles_as_sides,
                                   const Vcode& vcode) {
  const std::vector<std::string_view> text = text_lines(svg);
  std::vector<Line> lines = line_elements(text);
  for (const Line& diagonal : rectangle_diagonals(text)) {
    if (rectangles_as_sides) {
      for (const Line& side : sides(diagonal)) lines.push_back(side);
    } else {
      lines.push_back(diagonal);
    }
  }
  return to_unit_square(lines, vcode);
}

std::vector<SegmentD> to_unit_square(std::span<const SegmentD> segments, const Vcode& vcode) {
  const auto point = [](const PointD& p) { return Point2{{p.x, false}, {p.y, false}}; };
  std::vector<Line> lines;
  for (const SegmentD& s : segments) lines.push_back({point(s.a), point(s.b)});
  return to_unit_square(lines, vcode);
}

}  // namespace plumbline::inters
