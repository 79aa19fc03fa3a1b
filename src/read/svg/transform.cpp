#include "read/svg/transform.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// More functions in one attribute than this are refused: their product could grow without limit.
constexpr std::size_t kMaxFunctions = 1000;

using Arguments = std::vector<Rational>;

/// A function of the list: its text and its map.
struct Function {
  std::string text;
  ApproximateAffine result;
  const char* unit = "";  ///< of the bound
};

[[noreturn]] void malformed(std::string_view rest) {
  throw Unusable{"malformed transform", std::string(rest)};
}

ApproximateAffine exactly(Affine map) { return {std::move(map), 0}; }

ApproximateAffine rotation_about(const Arguments& a, double bound) {
  ApproximateAffine turned = rotation(a[0], bound);
  if (a.size() == 3) {
    turned.map = compose(translation(a[1], a[2]), compose(turned.map, translation(-a[1], -a[2])));
  }
  return turned;
}

/// Throws: Unusable, Error BadInput (a skew by a right angle).
ApproximateAffine map_of(std::string_view name, const Arguments& a, const std::string& text,
                         double bound) {
  const std::size_t count = a.size();
  if (name == "matrix" && count == 6) return exactly({a[0], a[1], a[2], a[3], a[4], a[5]});
  if (name == "translate" && count == 1) return exactly(translation(a[0], 0));
  if (name == "translate" && count == 2) return exactly(translation(a[0], a[1]));
  if (name == "scale" && count == 1) return exactly(scaling(a[0], a[0]));
  if (name == "scale" && count == 2) return exactly(scaling(a[0], a[1]));
  if (name == "rotate" && (count == 1 || count == 3)) return rotation_about(a, bound);
  if (name == "skewX" && count == 1) return skew_x(a[0], bound);
  if (name == "skewY" && count == 1) return skew_y(a[0], bound);
  for (const char* known : {"matrix", "translate", "scale", "rotate", "skewX", "skewY"}) {
    if (name == known) throw Unusable{"wrong number of arguments in transform", text};
  }
  throw Unusable{"unknown function in transform", text};
}

Arguments take_arguments(Scanner& scanner, Numbers& numbers) {
  Arguments arguments;
  bool comma = false;
  scanner.skip_blanks();
  while (scanner.at_number()) {
    arguments.push_back(numbers.take(scanner, "malformed transform").rational());
    comma = scanner.skip_separator();
  }
  if (comma || scanner.peek() != ')') malformed(scanner.rest(scanner.position()));
  scanner.advance();
  return arguments;
}

Function take_function(Scanner& scanner, Numbers& numbers, double bound) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::size_t begin = scanner.position();
  while (is_letter(scanner.peek())) scanner.advance();
  const std::string_view name = scanner.since(begin);
  scanner.skip_blanks();
  if (name.empty() || scanner.peek() != '(') malformed(scanner.rest(begin));
  scanner.advance();
  const Arguments arguments = take_arguments(scanner, numbers);
  Function function{
      std::string(scanner.since(begin)), {}, name == "rotate" ? " rad" : " (tangent)"};
  try {
    function.result = map_of(name, arguments, function.text, bound);
  } catch (const Error& error) {
    throw Unusable{error.message(), function.text};
  }
  return function;
}

bool is_small(const Affine& map) {
  return std::all_of(map.entries().begin(), map.entries().end(), [](const Number& entry) {
    const Rational value = entry.rational();
    return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2) <=
           kMaxMapBits;
  });
}

}  // namespace

SvgTransform parse_transform(std::string_view text, Numbers& numbers, double bound) {
  SvgTransform transform;
  Scanner scanner(text);
  scanner.skip_blanks();
  bool comma = false;
  for (std::size_t count = 1; !scanner.at_end(); ++count) {
    const Function function = take_function(scanner, numbers, bound);
    transform.map = count == 1 ? function.result.map : compose(transform.map, function.result.map);
    if (count > kMaxFunctions || !is_small(transform.map)) {
      throw Unusable{"the product of the transform is too large", std::string(text)};
    }
    if (function.result.bound != 0) {
      Replacement replaced;
      replaced.what = function.text;
      replaced.bound = shortest_text(nearest_double(function.result.bound)) + function.unit;
      transform.replaced.push_back(std::move(replaced));
    }
    comma = false;  // the grammar allows any number of separators between functions
    while (scanner.skip_separator()) comma = true;
  }
  if (comma) malformed(text);
  return transform;
}

}  // namespace plumbline
