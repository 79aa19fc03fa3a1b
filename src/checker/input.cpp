// Rows x1,y1,x2,y2 (segments) and x,y (isolated points).

#include "input.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "refusal.hpp"

namespace plumbline_checker {
namespace {

constexpr std::size_t kMaxFields = 4;
constexpr std::size_t kShortCoordinate = 1000;  // letters that cost next to nothing

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Printable and short.
std::string shown(std::string_view text) {
  constexpr std::size_t kShown = 60;
  std::string result;
  for (const char c : text.substr(0, kShown)) result += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > kShown ? result + "..." : result;
}

std::size_t bits(const mpz_class& z) { return mpz_sizeinbase(z.get_mpz_t(), 2); }
std::size_t bits(const Number& n) { return std::max(bits(n.numerator), bits(n.denominator)); }
std::size_t bits(const Point& p) { return std::max(bits(p.x), bits(p.y)); }

/// A coordinate of a crossing is, before it is reduced, a quotient of two by two determinants of
/// the lines' numbers.
std::size_t longest_coordinate(const Input& input) {
  std::size_t of_lines = 0;
  std::size_t most = 0;
  for (const auto& [first, last, reversed, line] : input.segments) {
    most = std::max({most, bits(first), bits(last)});
    of_lines = std::max({of_lines, bits(line.a), bits(line.b), bits(line.c)});
  }
  for (const Point& point : input.points) most = std::max(most, bits(point));
  most = std::max(most, 2 * of_lines + 1);
  const std::size_t digits = most * 302 / 1000 + 1;  // log10(2) < 0.302
  const std::size_t sign_and_slash = 2;
  return std::max(kShortCoordinate, 2 * digits + sign_and_slash);
}

class Rows {
 public:
  explicit Rows(Input& input) : input_(input) {}

  /// Requires: a row that is not blank.
  void add(std::string_view row, std::size_t line) {
    std::array<Number, kMaxFields> values;
    std::size_t count = 0;
    for (bool more = true; more; ++count) {
      const std::string_view field = row.substr(0, row.find(','));
      more = field.size() < row.size();
      row.remove_prefix(more ? field.size() + 1 : field.size());
      if (count == kMaxFields) throw BadInput{"a row of more than 4 numbers", line};
      std::optional<Number> value = input_number(trimmed(field));
      if (!value) throw BadInput{"\"" + shown(field) + "\" is not a number that can be read", line};
      values[count] = *std::move(value);
    }
    auto& [ax, ay, bx, by] = values;
    if (count == 2) {
      input_.points.push_back({std::move(ax), std::move(ay)});
    } else if (count == kMaxFields) {
      add_segment({std::move(ax), std::move(ay)}, {std::move(bx), std::move(by)});
    } else {
      throw BadInput{"a row of " + std::to_string(count) + " numbers, not of 4 or 2", line};
    }
  }

 private:
  void add_segment(Point start, Point end) {
    const int order = compare(start, end);
    if (order == 0) {
      ++input_.without_length;
      return;
    }
    const bool reversed = order > 0;
    if (reversed) std::swap(start, end);
    Line line = line_through(start, end);
    input_.segments.push_back({std::move(start), std::move(end), reversed, std::move(line)});
  }

  Input& input_;
};

}  // namespace

Input read_input(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Input input;
  Rows rows(input);
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    if (const std::string_view row = trimmed(whole); !row.empty()) rows.add(row, line);
  }
  input.longest_coordinate = longest_coordinate(input);
  return input;
}

}  // namespace plumbline_checker
