// Expressions of regions: "A - (B | C)", "count >= 2".

#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

using Predicate = std::function<bool(const Membership&)>;
using Number = std::function<std::size_t(const Membership&)>;

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("_.:*?$#").find(c) != std::string_view::npos ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Reads an expression from left to right; each function what its name says, up to its end.
class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& names)
      : text_(text), names_(names) {}

  Predicate whole() {
    Predicate result = sum();
    skip_spaces();
    if (at_ < text_.size()) fail("what is this? An operator is one of & | ^ -");
    return result;
  }

 private:
  Predicate sum() {
    Predicate left = product();
    while (true) {
      if (takes('|')) {
        left = [a = std::move(left), b = product()](const auto& m) { return a(m) || b(m); };
      } else if (takes('^')) {
        left = [a = std::move(left), b = product()](const auto& m) { return a(m) != b(m); };
      } else if (takes('-')) {
        left = [a = std::move(left), b = product()](const auto& m) { return a(m) && !b(m); };
      } else {
        return left;
      }
    }
  }

  Predicate product() {
    Predicate left = factor();
    while (takes('&')) {
      left = [a = std::move(left), b = factor()](const auto& m) { return a(m) && b(m); };
    }
    return left;
  }

  Predicate factor() {
    skip_spaces();
    if (takes('!')) return [a = factor()](const auto& m) { return !a(m); };
    if (takes('(')) {
      Predicate inner = sum();
      if (!takes(')')) fail("a parenthesis is not closed");
      return inner;
    }
    const bool is_quoted = at_ < text_.size() && (text_[at_] == '\'' || text_[at_] == '"');
    const std::size_t start = at_;
    const std::string name = this->name();
    if (name != "count" || is_quoted) return any_of(numbers_of(name, start));
    return comparison();
  }

  /// What follows `count`.
  Predicate comparison() {
    Number number = [](const Membership& m) { return m.count(); };
    if (takes('(')) {
      const std::size_t start = at_;
      number = [of = numbers_of(name(), start)](const Membership& m) {
        std::size_t sum = 0;
        for (const std::size_t n : of) sum += m.count(n);
        return sum;
      };
      if (!takes(')')) fail("a parenthesis is not closed");
    }
    skip_spaces();
    const std::size_t start = at_;
    while (at_ < text_.size() && std::string_view("<>=!").find(text_[at_]) != std::string::npos) {
      ++at_;
    }
    const std::string_view sign = text_.substr(start, at_ - start);
    skip_spaces();
    std::size_t bound = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), bound);
    if (error != std::errc()) fail("count is compared with a number: count >= 2");
    at_ = static_cast<std::size_t>(end - text_.data());
    return compared(number, sign, bound, start);
  }

  Predicate compared(const Number& n, std::string_view sign, std::size_t bound, std::size_t start) {
    if (sign == "<") return [n, bound](const auto& m) { return n(m) < bound; };
    if (sign == "<=") return [n, bound](const auto& m) { return n(m) <= bound; };
    if (sign == "=" || sign == "==") return [n, bound](const auto& m) { return n(m) == bound; };
    if (sign == "!=") return [n, bound](const auto& m) { return n(m) != bound; };
    if (sign == ">=") return [n, bound](const auto& m) { return n(m) >= bound; };
    if (sign == ">") return [n, bound](const auto& m) { return n(m) > bound; };
    at_ = start;
    fail("count is compared by one of < <= = != >= >");
  }

  std::string name() {
    skip_spaces();
    if (at_ < text_.size() && (text_[at_] == '\'' || text_[at_] == '"')) {
      const std::size_t end = text_.find(text_[at_], at_ + 1);
      if (end == std::string_view::npos) fail("a quotation mark is not closed");
      std::string result(text_.substr(at_ + 1, end - at_ - 1));
      at_ = end + 1;
      return result;
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
    if (at_ == start) {
      fail(at_ == text_.size() ? "a name is missing at the end" : "a name is missing");
    }
    return std::string(text_.substr(start, at_ - start));
  }

  /// The names that a pattern stands for.
  std::vector<std::size_t> numbers_of(const std::string& pattern, std::size_t start) {
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n < names_.size(); ++n) {
      if (is_layer(names_[n], pattern)) found.push_back(n);
    }
    if (!found.empty()) return found;
    at_ = start;
    std::string known;
    for (std::size_t n = 0; n < std::min<std::size_t>(names_.size(), 10); ++n) {
      known += (n == 0 ? "" : ", ") + names_[n];
    }
    fail("no region has this name; there are " + (known.empty() ? "none" : known) +
         " (in quotation marks where a name has - or spaces)");
  }

  static Predicate any_of(std::vector<std::size_t> names) {
    return [names = std::move(names)](const Membership& m) {
      return std::any_of(names.begin(), names.end(), [&](std::size_t n) { return m.count(n) > 0; });
    };
  }

  bool takes(char c) {
    skip_spaces();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void skip_spaces() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorCode::BadInput, what, {"", 0, static_cast<std::uint32_t>(at_ + 1)},
                std::string(text_.substr(std::min(at_, text_.size()))));
  }

  std::string_view text_;
  const std::vector<std::string>& names_;
  std::size_t at_ = 0;
};

}  // namespace

FaceSet select(const LabelledComplex& labelled, std::string_view expression) {
  const Membership none(labelled);
  return select(labelled, Parser(expression, none.names()).whole());
}

}  // namespace plumbline
