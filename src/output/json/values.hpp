#pragma once

#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "plumbline/geometry/point_list.hpp"

/// JSON documents as values: `document(object(member("x", x), member("y", list(ys, f))))` is the
/// text. Values are written as they are met; no tree is built of them.
namespace plumbline::json {

/// The numbers from the first on, up to and without the last. (clang 14 does not compile
/// std::views::iota of this standard library.)
class Numbers {
 public:
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = std::size_t;

    Iterator() = default;
    explicit Iterator(std::size_t number) : number_(number) {}
    std::size_t operator*() const { return number_; }
    Iterator& operator++() {
      ++number_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(number_++); }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::size_t number_ = 0;
  };

  Numbers(std::size_t first, std::size_t last) : first_(first), last_(last) {}
  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return Iterator(last_); }

 private:
  std::size_t first_, last_;
};

/// How a value keeps what it is made of: small things and temporaries itself; anything else stays
/// where it is and must outlive the value.
template <class T, class U = std::decay_t<T>>
using Kept = std::conditional_t<std::is_lvalue_reference_v<T> &&
                                    !(std::is_trivially_copyable_v<U> && sizeof(U) <= 16),
                                const U&, U>;

// What stands between the braces of an object: a member, or several.

template <class Key, class T>
struct Member {
  Key key;
  T value;
};
template <class Key, class T>
Member<Kept<Key>, Kept<T>> member(Key&& key, T&& value) {
  return {std::forward<Key>(key), std::forward<T>(value)};
}

template <class... Parts>
struct Members {
  std::tuple<Parts...> parts;
};
template <class... Parts>
Members<Parts...> members(Parts... parts) {
  return {{std::move(parts)...}};
}

/// f(), but nothing where the condition does not hold.
template <class F>
struct When {
  bool is_there;
  F f;
};
template <class Condition, class F>
When<F> when(const Condition& condition, F f) {
  return {static_cast<bool>(condition), std::move(f)};
}

/// f(item) for each item.
template <class Range, class F>
struct Each {
  Range range;
  F f;
};
template <std::ranges::range Range, class F>
Each<Kept<Range>, F> each(Range&& range, F f) {
  return {std::forward<Range>(range), std::move(f)};
}

// Values. Others are written as they are: texts, numbers (an infinite one as null), points and
// ranges as arrays, optionals and indices as null where there is nothing.

template <class... Parts>
struct Object {
  std::tuple<Parts...> parts;
};
template <class... Parts>
Object<Parts...> object(Parts... parts) {
  return {{std::move(parts)...}};
}

/// The array of f(item) for each item; of f(0), f(1), ... for a number of items.
template <class Range, class F>
struct List {
  Range range;
  F f;
};
template <std::ranges::range Range, class F>
List<Kept<Range>, F> list(Range&& range, F f) {
  return {std::forward<Range>(range), std::move(f)};
}
template <class F>
auto list(std::size_t count, F f) {
  return list(Numbers(0, count), std::move(f));
}

/// The same array, each item on a line of its own.
template <class Range, class F>
struct Rows {
  Range range;
  F f;
};
template <std::ranges::range Range, class F>
Rows<Kept<Range>, F> rows(Range&& range, F f) {
  return {std::forward<Range>(range), std::move(f)};
}

/// f(*known), or null where nothing is known: no value of an optional, a null pointer.
template <class Known, class F>
auto given(const Known& known, F f) {
  using Value = decltype(f(*known));
  return known ? std::optional<Value>(f(*known)) : std::nullopt;
}
/// f(), or null where the condition does not hold.
template <class F>
auto given(bool condition, F f) {
  return condition ? std::optional(f()) : std::nullopt;
}

/// The digits of a number.
struct Digits {
  std::string text;
};

/// Point i of a list, as it is stored.
struct Stored {
  const PointList& points;
  std::size_t i;
};

/// A number where the value is a decimal, else a string "p/q".
std::variant<Digits, std::string> decimal(const Rational& value);
/// {exact, nearest}, of a point or a number.
inline auto place(const Point& p) {
  return object(member("exact", p), member("nearest", nearest(p)));
}
inline auto with_nearest(const Rational& number) {
  return object(member("exact", number), member("nearest", nearest_double(number)));
}

}  // namespace plumbline::json
