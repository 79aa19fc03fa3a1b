#pragma once

#include <charconv>
#include <concepts>
#include <functional>
#include <string>
#include <string_view>

#include "number/wide.hpp"
#include "output/json/values.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::json {

/// How a document is laid out: members on lines of their own, arrays on one line; or without
/// blanks.
enum class Layout { Readable, Dense };

/// Writes such values, each as it is met, to the end of one text.
class Writer {
 public:
  explicit Writer(Layout layout = Layout::Readable) : is_readable_(layout == Layout::Readable) {}
  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  std::string take() { return std::move(text_) + '\n'; }

  template <class T>
  void value(const T& x) {
    if constexpr (std::is_same_v<T, bool>) {
      text_ += x ? "true" : "false";
    } else if constexpr (std::integral<T>) {
      number(x);
    } else if constexpr (std::is_convertible_v<T, std::string_view>) {
      quoted(x);
    } else {
      array(x, std::identity());
    }
  }
  void value(std::monostate) { null(); }
  void value(double x);
  void value(const Digits& digits) { text_ += digits.text; }
  void value(const Rational& x) { plain(exact_text(x)); }
  void value(const Number& x);
  void value(const Stored& point);
  void value(const Point& p) { value(std::tie(p.x, p.y)); }
  void value(const PointD& p) { value(std::tie(p.x, p.y)); }
  void value(const SegmentD& s) { value(std::tie(s.a, s.b)); }
  template <class... T>
  void value(const std::tuple<T...>& x) {
    text_ += '[';
    ++depth_;
    bool is_first = true;
    const auto add = [&](const auto& item) {
      separate(is_first);
      value(item);
    };
    std::apply([&](const auto&... item) { (add(item), ...); }, x);
    --depth_;
    text_ += ']';
  }
  template <class Tag>
  void value(const Index<Tag>& index) {
    index.valid() ? value(std::size_t{index}) : null();
  }
  template <class T>
  void value(const std::optional<T>& x) {
    x ? value(*x) : null();
  }
  template <class... T>
  void value(const std::variant<T...>& x) {
    std::visit([this](const auto& held) { this->value(held); }, x);
  }
  template <class T>
  void value(const Lists<T>& lists) {
    value(list(lists.size(), [&lists](std::size_t i) { return lists[i]; }));
  }
  template <class Range, class F>
  void value(const List<Range, F>& x) {
    array(x.range, x.f);
  }
  template <class Range, class F>
  void value(const Rows<Range, F>& x) {
    text_ += '[';
    bool is_first = true;
    for (const auto& item : x.range) {
      text_ += is_first ? "\n" : ",\n";
      is_first = false;
      value(x.f(item));
    }
    text_ += is_first ? "]" : "\n]";
  }
  template <class... Parts>
  void value(const Object<Parts...>& x) {
    text_ += '{';
    ++depth_;
    is_empty_ = true;
    all(x.parts);
    --depth_;
    if (!is_empty_) new_line();
    is_empty_ = false;  // what this is a part of
    text_ += '}';
  }

  template <class Key, class T>
  void part(const Member<Key, T>& x) {
    key(x.key);
    value(x.value);
  }
  template <class... Parts>
  void part(const Members<Parts...>& x) {
    all(x.parts);
  }
  template <class F>
  void part(const When<F>& x) {
    if (x.is_there) part(x.f());
  }
  template <class Range, class F>
  void part(const Each<Range, F>& x) {
    for (const auto& item : x.range) part(x.f(item));
  }
  void part(const std::function<void(Writer&)>& write) { write(*this); }

 private:
  void null() { text_ += "null"; }
  template <std::integral T>
  void number(T x) {
    char digits[20];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  }
  void fraction(const wide::Fraction& x);
  /// A text without anything that JSON escapes.
  void plain(std::string_view words) { ((text_ += '"') += words) += '"'; }
  void quoted(std::string_view words);
  void key(std::string_view name);
  void new_line();
  /// Between the items of an array.
  void separate(bool& is_first) {
    if (!is_first) text_ += is_readable_ ? ", " : ",";
    is_first = false;
  }
  template <class Range, class F>
  void array(const Range& range, const F& f) {
    text_ += '[';
    ++depth_;
    bool is_first = true;
    for (const auto& item : range) {
      separate(is_first);
      value(f(item));
    }
    --depth_;
    text_ += ']';
  }
  template <class... Parts>
  void all(const std::tuple<Parts...>& parts) {
    std::apply([this](const auto&... x) { (this->part(x), ...); }, parts);
  }

  bool is_readable_;
  std::string text_;
  std::size_t depth_ = 0;  ///< of arrays and objects around what is written
  bool is_empty_ = true;   ///< whether the innermost object has no member so far
};

/// Parts of an object whose type is of no interest, for those that are made in another source.
using Part = std::function<void(Writer&)>;
template <class T>
Part part_of(T part) {
  return [part = std::move(part)](Writer& writer) { writer.part(part); };
}

/// The text of a file, of about so many bytes.
template <class T>
std::string document(const T& value, Layout layout = Layout::Readable, std::size_t bytes = 0) {
  Writer writer(layout);
  writer.reserve(bytes);
  writer.value(value);
  return writer.take();
}

}  // namespace plumbline::json
