// What the texts for a terminal have in common.

#include "output/text/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownInputs = 3;
// Longer numbers are what a program computed.
constexpr std::ptrdiff_t kOwnDigits = 12;

/// The nearest multiple of 10^-decimals; of 1/2 the greater one.
Rational rounded(const Rational& value, unsigned long decimals) {
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, decimals);
  const Rational scaled = value * scale + Rational(1, 2);
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational result(floor, scale);
  result.canonicalize();
  return result;
}

std::string coordinate(const Rational& value, double tolerance) {
  const std::string whole = shortest_text(nearest_double(value));
  const std::string mantissa = whole.substr(0, whole.find('e'));
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  if (std::count_if(mantissa.begin(), mantissa.end(), is_digit) <= kOwnDigits) return whole;
  // 10^-decimals / 2 is at most tolerance / 100.
  const double decimals = std::ceil(-std::log10(tolerance / 50));
  if (!(decimals < 400)) return whole;
  return shortest_text(
      nearest_double(rounded(value, static_cast<unsigned long>(std::max(decimals, 0.0)))));
}

}  // namespace

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string cut(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string place_text(const Point& place, double tolerance) {
  return fmt::format("({}, {})", coordinate(place.x, tolerance), coordinate(place.y, tolerance));
}

std::string input_lines(const SegmentSet& input, const std::vector<SegmentId>& segments,
                        std::string_view indent) {
  const std::vector<SourceId> sources = sources_of(input, segments);
  const std::size_t shown = std::min(sources.size(), kShownInputs);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    text +=
        fmt::format("{}{}\n", indent, line_text(to_text(input.sources[sources[i]], input.files)));
  }
  if (shown < sources.size()) {
    text += fmt::format("{}and {} more\n", indent, sources.size() - shown);
  }
  return text;
}

}  // namespace plumbline
