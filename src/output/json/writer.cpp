#include "output/json/writer.hpp"

#include <algorithm>
#include <cmath>

#include "plumbline/error.hpp"

namespace plumbline::json {

std::variant<Digits, std::string> decimal(const Rational& value) {
  std::string text = exact_text(value);
  if (text.find('/') != std::string::npos) return text;
  return Digits{std::move(text)};
}

void Writer::value(double x) {
  if (!std::isfinite(x)) return null();
  char digits[32];                      // the longest is 24: -2.2250738585072014e-308
  const double shown = x == 0 ? 0 : x;  // -0 -> 0
  text_.append(digits, std::to_chars(digits, digits + sizeof digits, shown).ptr);
}

void Writer::fraction(const wide::Fraction& x) {
  text_ += '"';
  if (!wide::append_exact(text_, x)) text_ += exact_text(wide::quotient(x.n, x.d));
  text_ += '"';
}

void Writer::value(const Number& x) {
  if (!x.is_decimal()) return value(x.held_rational());
  fraction(wide::lowest(x.mantissa(), wide::kPowersOfTen[static_cast<std::size_t>(x.digits())]));
}

void Writer::value(const Stored& point) {
  const WidePoint* p = point.points.wide(point.i);
  if (p == nullptr) return value(point.points[point.i]);
  text_ += '[';
  bool is_first = true;
  for (const wide::Int128 coordinate : {p->x, p->y}) {
    separate(is_first);
    fraction(wide::lowest(coordinate, p->w));
  }
  text_ += ']';
}

void Writer::quoted(std::string_view words) {
  const auto is_plain = [](char c) { return ' ' <= c && c <= '~' && c != '"' && c != '\\'; };
  if (std::all_of(words.begin(), words.end(), is_plain)) return plain(words);
  text_ += '"';
  for (const char c : valid_utf8(words)) {
    static constexpr std::string_view kShort = "\"\\\b\f\n\r\t", kLetters = "\"\\bfnrt";
    static constexpr std::string_view kDigits = "0123456789ABCDEF";
    const std::size_t at = kShort.find(c);
    const auto code = static_cast<unsigned char>(c);
    if (at != std::string_view::npos) {
      (text_ += '\\') += kLetters[at];
    } else if (code < ' ') {
      ((text_ += "\\u00") += kDigits[code / 16]) += kDigits[code % 16];
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

void Writer::key(std::string_view name) {
  if (!is_empty_) text_ += ',';
  is_empty_ = false;
  new_line();
  quoted(name);
  text_ += is_readable_ ? ": " : ":";
}

void Writer::new_line() {
  if (!is_readable_) return;
  text_ += '\n';
  text_.append(depth_, ' ');
}

}  // namespace plumbline::json
