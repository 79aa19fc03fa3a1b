#include "read/svg/length.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "number/leading_decimal.hpp"

namespace plumbline {
namespace {

/// An absolute unit: so many user units, numerator / denominator.
struct NamedLength {
  std::string_view name;
  int numerator;
  int denominator;
};

constexpr int kUserUnitsPerInch = 96;
constexpr std::array<NamedLength, 7> kUnits{{{"px", 1, 1},
                                             {"in", 96, 1},
                                             {"cm", 96 * 100, 254},
                                             {"mm", 96 * 10, 254},
                                             {"q", 96 * 10, 254 * 4},
                                             {"pt", 96, 72},
                                             {"pc", 96, 6}}};

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

Number in_user_units(const Number& value, std::string_view unit,
                     const std::optional<Rational>& whole, std::string_view text) {
  if (unit.empty()) return value;
  if (unit == "%") {
    if (!whole) throw Unusable{"percentage of an unknown extent", std::string(text)};
    return Number(Rational(value.rational() * *whole / 100));
  }
  const std::string name = lower_case(unit);
  for (const NamedLength& known : kUnits) {
    if (name != known.name) continue;
    return known.denominator == 1
               ? value * Number::decimal(known.numerator, 0)
               : Number(Rational(value.rational() * known.numerator / known.denominator));
  }
  throw Unusable{"unit " + std::string(unit) + " is not understood", std::string(text)};
}

}  // namespace

Number parse_length(std::string_view text, const std::optional<Rational>& whole, Numbers& numbers) {
  LeadingDecimal plain = leading_decimal(text);
  if (plain.length == text.size() && !text.empty()) return numbers.read(std::move(plain.value));
  Scanner scanner(text);
  scanner.skip_blanks();
  const std::string_view number = scanner.number();
  scanner.advance_by(number.size());
  const std::size_t unit_begin = scanner.position();
  while (!scanner.at_end() && !scanner.at_blank()) scanner.advance();
  const std::string_view unit = scanner.since(unit_begin);
  scanner.skip_blanks();
  if (number.empty() || !scanner.at_end()) throw Unusable{"not a length", std::string(text)};
  return in_user_units(numbers.parse(number), unit, whole, text);
}

bool is_physical_length(std::string_view text) {
  const std::string name = lower_case(text.substr(0, text.find_last_not_of(" \t\r\n") + 1));
  const auto is_unit = [&](const NamedLength& unit) {
    return unit.name != "px" && name.ends_with(unit.name);
  };
  return std::any_of(kUnits.begin(), kUnits.end(), is_unit);
}

LengthUnit svg_unit(const Rational& user_units) {
  const Rational metres = user_units * Rational(254, 10'000) / kUserUnitsPerInch;
  for (const NamedLength& known : kUnits) {
    if (user_units * known.denominator == known.numerator) return {std::string(known.name), metres};
  }
  if (metres == 1) return {"m", metres};
  return {"user unit", metres};
}

Number length_attribute(const pugi::xml_node& element, const char* name,
                        const std::optional<Rational>& whole, Numbers& numbers) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return {};
  try {
    return parse_length(attribute.value(), whole, numbers);
  } catch (const Unusable& problem) {
    throw Unusable{problem.reason, quoted(name, attribute.value())};
  }
}

std::string quoted(const char* name, std::string_view value) {
  return std::string(name) + "=\"" + std::string(value) + "\"";
}

}  // namespace plumbline
