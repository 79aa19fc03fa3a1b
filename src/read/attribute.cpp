#include "read/attribute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "number/bound_text.hpp"
#include "number/short_decimal.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && is_digit(text[i])) ++i;
  return i;
}

}  // namespace

Number Numbers::parse(std::string_view text) { return read(parse_whole(text)); }

Number Numbers::shortened(Number value) {
  Number shorter = short_decimal(value);
  if (shorter == value) return value;
  ++shortened_;
  const Rational change = shorter.rational() - value.rational();
  largest_change_ = std::max(largest_change_, std::abs(nearest_double(change)));
  return shorter;
}

void Numbers::add_to(std::vector<Replacement>& ledger) const {
  if (shortened_ == 0) return;
  ledger.push_back({{},
                    fmt::format("{} printed double{} by decimals of at most {} digits", shortened_,
                                shortened_ == 1 ? "" : "s", kShortDigits),
                    bound_text(largest_change_) + " units"});
}

Number Numbers::parse_whole(std::string_view text) {
  try {
    Number value = parse_number(text);
    if (value.is_decimal()) return value;
    const Rational exact = value.rational();
    const std::size_t words = mpz_size(exact.get_num_mpz_t()) + mpz_size(exact.get_den_mpz_t());
    if (words > kPlainWords) long_words_ += words;
    if (long_words_ <= kMaxLongWords) return value;
  } catch (const Error& error) {
    throw Unusable{error.message(), std::string(text.substr(0, 100))};
  }
  throw Error(ErrorCode::Limit, "the long numbers of the document take more than 128 MiB", {},
              std::string(text));
}

Number Numbers::take(Scanner& scanner, const char* reason) {
  const std::string_view number = scanner.number();
  if (number.empty()) throw Unusable{reason, {}};
  Number value = parse(number);
  scanner.advance_by(number.size());
  return value;
}

bool Scanner::at_blank() const { return is_blank(peek()); }

void Scanner::skip_blanks() {
  while (at_blank()) ++position_;
}

bool Scanner::skip_separator() {
  skip_blanks();
  if (peek() != ',') return false;
  advance();
  skip_blanks();
  return true;
}

std::string_view Scanner::number() const {
  const std::string_view text = text_.substr(position_);
  std::size_t end = !text.empty() && is_sign(text[0]) ? 1 : 0;
  const std::size_t whole = end;
  end = skip_digits(text, end);
  std::size_t digits = end - whole;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = end + 1;
    end = skip_digits(text, fraction);
    digits += end - fraction;
  }
  if (digits == 0) return {};
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && is_sign(text[exponent])) ++exponent;
    // Without digits the letter is no exponent but what follows the number: "1em".
    const std::size_t exponent_end = skip_digits(text, exponent);
    if (exponent_end > exponent) end = exponent_end;
  }
  return text.substr(0, end);
}

}  // namespace plumbline
