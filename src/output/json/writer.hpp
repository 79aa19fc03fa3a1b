#pragma once

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <concepts>
#include <functional>
#include <string_view>

#include "output/json/values.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::json {

/// RapidJSON's writer for such values. Arrays stand on one line.
class Writer : private rapidjson::PrettyWriter<rapidjson::StringBuffer> {
 public:
  Writer();
  std::string take() const;

  template <class T>
  void value(const T& x) {
    if constexpr (std::is_same_v<T, bool>) {
      Bool(x);
    } else if constexpr (std::signed_integral<T>) {
      Int64(x);
    } else if constexpr (std::unsigned_integral<T>) {
      Uint64(x);
    } else if constexpr (std::is_convertible_v<T, std::string_view>) {
      text(x);
    } else {
      array(x, std::identity());
    }
  }
  void value(double number);
  void value(const Digits& digits);
  void value(const Rational& number) { text(exact_text(number)); }
  void value(const Point& p) { value(std::tie(p.x, p.y)); }
  void value(const PointD& p) { value(std::tie(p.x, p.y)); }
  void value(const SegmentD& s) { value(std::tie(s.a, s.b)); }
  template <class... T>
  void value(const std::tuple<T...>& x) {
    StartArray();
    std::apply([this](const auto&... item) { (this->value(item), ...); }, x);
    EndArray();
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
  template <class... Parts>
  void value(const Object<Parts...>& x) {
    StartObject();
    all(x.parts);
    EndObject();
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
  void null() { Null(); }
  void text(std::string_view words);
  void key(std::string_view name);
  template <class Range, class F>
  void array(const Range& range, const F& f) {
    StartArray();
    for (const auto& item : range) value(f(item));
    EndArray();
  }
  template <class... Parts>
  void all(const std::tuple<Parts...>& parts) {
    std::apply([this](const auto&... x) { (this->part(x), ...); }, parts);
  }

  rapidjson::StringBuffer buffer_;
};

/// Parts of an object whose type is of no interest, for those that are made in another source.
using Part = std::function<void(Writer&)>;
template <class T>
Part part_of(T part) {
  return [part = std::move(part)](Writer& writer) { writer.part(part); };
}

/// The text of a file.
template <class T>
std::string document(const T& value) {
  Writer writer;
  writer.value(value);
  return writer.take();
}

}  // namespace plumbline::json
