#include "plumbline/engines/inters_vcode.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "plumbline/error.hpp"

namespace plumbline::inters {
namespace {

constexpr int kSignificantDigits = 12;  ///< of Python 2.7's str
constexpr double kFirstInexact = 1e12;  ///< the least integer of more digits

}  // namespace

Vcode::Vcode(int decimals) : power_(1) {
  if (decimals < 0 || decimals > kMaxDecimals) {
    throw Error(ErrorCode::BadInput, "the number of decimals must be from 0 to 12", {},
                std::to_string(decimals));
  }
  for (int i = 0; i < decimals; ++i) power_ *= 10;
}

std::string Vcode::text(double value) const {
  const double rounded = std::round(value * power_) / power_;
  std::array<char, 32> digits{};
  char* const end = std::to_chars(digits.begin(), digits.end(), rounded == 0 ? 0.0 : rounded,
                                  std::chars_format::general, kSignificantDigits)
                        .ptr;
  std::string text(digits.data(), end);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

double Vcode::quantised(double value) const {
  // Up to 12 digits, the text is that of rounded / power_ in decimals, and the division, of two
  // integers, gives the double nearest to that.
  const double rounded = std::round(value * power_);
  if (std::abs(rounded) < kFirstInexact) return rounded == 0 ? 0.0 : rounded / power_;
  const std::string digits = text(value);
  double result = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), result);
  return result;
}

std::string Vcode::text(const PointD& p) const { return '[' + text(p.x) + ", " + text(p.y) + ']'; }

}  // namespace plumbline::inters
