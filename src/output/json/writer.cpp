#include "output/json/writer.hpp"

#include "plumbline/error.hpp"

namespace plumbline::json {

std::variant<Digits, std::string> decimal(const Rational& value) {
  std::string text = exact_text(value);
  if (text.find('/') != std::string::npos) return text;
  return Digits{std::move(text)};
}

Writer::Writer() {
  Reset(buffer_);
  SetIndent(' ', 1);
  SetFormatOptions(rapidjson::kFormatSingleLineArray);
}

std::string Writer::take() const {
  return std::string(buffer_.GetString(), buffer_.GetSize()) + '\n';
}

void Writer::value(double number) {
  Digits digits{shortest_text(number)};
  digits.text.find_first_of("in") == std::string::npos ? value(digits) : null();
}

void Writer::value(const Digits& digits) {
  RawValue(digits.text.data(), digits.text.size(), rapidjson::kNumberType);
}

void Writer::text(std::string_view words) {
  const std::string utf8 = valid_utf8(words);
  String(utf8.data(), static_cast<rapidjson::SizeType>(utf8.size()));
}

void Writer::key(std::string_view name) {
  const std::string utf8 = valid_utf8(name);
  Key(utf8.data(), static_cast<rapidjson::SizeType>(utf8.size()));
}

}  // namespace plumbline::json
