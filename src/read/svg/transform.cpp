#include "read/svg/transform.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// More functions in one attribute than this are refused: their product could grow without limit.
constexpr std::size_t kMaxFunctions = 1000;

using Arguments = std::vector<Rational>;

/// A function of the list: its text and its maps.
struct Function {
  std::string text;
  std::vector<Struct::Item> maps;
  Rational bound;  ///< on the tangent, of a skew
};

[[noreturn]] void malformed(std::string_view rest) {
  throw Unusable{"malformed transform", std::string(rest)};
}

Function exactly(Affine map) { return {{}, {std::move(map)}, 0}; }

Function skewed(ApproximateAffine skew) { return {{}, {std::move(skew.map)}, skew.bound}; }

Function rotation_about(const Arguments& a) {
  Struct::Item turn = rotation_item(a[0], {});
  if (a.size() == 1) return {{}, {std::move(turn)}, 0};
  return {{}, {translation(a[1], a[2]), std::move(turn), translation(-a[1], -a[2])}, 0};
}

/// Without its text. Throws: Unusable, Error BadInput (a skew by a right angle).
Function function_of(std::string_view name, const Arguments& a, std::string_view text,
                     double bound) {
  const std::size_t count = a.size();
  if (name == "matrix" && count == 6) return exactly({a[0], a[1], a[2], a[3], a[4], a[5]});
  if (name == "translate" && count == 1) return exactly(translation(a[0], 0));
  if (name == "translate" && count == 2) return exactly(translation(a[0], a[1]));
  if (name == "scale" && count == 1) return exactly(scaling(a[0], a[0]));
  if (name == "scale" && count == 2) return exactly(scaling(a[0], a[1]));
  if (name == "rotate" && (count == 1 || count == 3)) return rotation_about(a);
  if (name == "skewX" && count == 1) return skewed(skew_x(a[0], bound));
  if (name == "skewY" && count == 1) return skewed(skew_y(a[0], bound));
  for (const char* known : {"matrix", "translate", "scale", "rotate", "skewX", "skewY"}) {
    if (name == known) throw Unusable{"wrong number of arguments in transform", std::string(text)};
  }
  throw Unusable{"unknown function in transform", std::string(text)};
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
  const std::string text(scanner.since(begin));
  try {
    Function function = function_of(name, arguments, text, bound);
    function.text = text;
    return function;
  } catch (const Error& error) {
    throw Unusable{error.message(), text};
  }
}

bool is_small(const Struct::Item& item) {
  const auto* map = std::get_if<Affine>(&item);
  return map == nullptr ||
         std::all_of(map->entries().begin(), map->entries().end(), [](const Number& entry) {
           const Rational value = entry.rational();
           return mpz_sizeinbase(value.get_num_mpz_t(), 2) +
                      mpz_sizeinbase(value.get_den_mpz_t(), 2) <=
                  kMaxMapBits;
         });
}

/// Appends a map, to the last one where neither is a Turn.
void append(std::vector<Struct::Item>& maps, Struct::Item map) {
  auto* last = maps.empty() ? nullptr : std::get_if<Affine>(&maps.back());
  const auto* affine = std::get_if<Affine>(&map);
  if (last != nullptr && affine != nullptr) {
    *last = compose(*last, *affine);
  } else {
    maps.push_back(std::move(map));
  }
}

}  // namespace

SvgTransform parse_transform(std::string_view text, Numbers& numbers, double bound) {
  SvgTransform transform;
  Scanner scanner(text);
  scanner.skip_blanks();
  bool comma = false;
  for (std::size_t count = 1; !scanner.at_end(); ++count) {
    Function function = take_function(scanner, numbers, bound);
    for (Struct::Item& map : function.maps) {
      append(transform.maps, std::move(map));
      if (count > kMaxFunctions || !is_small(transform.maps.back())) {
        throw Unusable{"the product of the transform is too large", std::string(text)};
      }
    }
    if (function.bound != 0) {
      Replacement replaced;
      replaced.what = function.text;
      replaced.bound = shortest_text(nearest_double(function.bound)) + " (tangent)";
      transform.replaced.push_back(std::move(replaced));
    }
    comma = false;  // the grammar allows any number of separators between functions
    while (scanner.skip_separator()) comma = true;
  }
  if (comma) malformed(text);
  return transform;
}

}  // namespace plumbline
