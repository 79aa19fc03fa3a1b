#pragma once

#include <array>
#include <span>
#include <vector>

#include "output/json/writer.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline {

/// JSON of the types that a trace of the float pipeline is made of.
class TraceWriter : public JsonWriter {
 public:
  void value(double number) { JsonWriter::number(number); }
  void value(int number) { Int(number); }
  void value(std::size_t number) { count(number); }
  void value(std::ptrdiff_t number) { Int64(number); }
  template <class Tag>
  void value(Index<Tag> index) {
    count(index);
  }
  void value(const PointD& p) { values(std::array{p.x, p.y}); }
  void value(const SegmentD& s) { values(std::array{s.a, s.b}); }
  template <class T>
  void value(const std::vector<T>& list) {
    values(list);
  }
  template <class T>
  void value(std::span<const T> list) {
    values(list);
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& list) {
    values(list);
  }
  template <class T>
  void value(const Lists<T>& lists) {
    StartArray();
    for (std::size_t i = 0; i < lists.size(); ++i) value(lists[i]);
    EndArray();
  }
  template <class T>
  void value(const inters::Outcome<T>& outcome) {
    if (outcome.value) {
      value(*outcome.value);
    } else {
      value(*outcome.failure);
    }
  }
  void value(const inters::Failure& failure) {
    StartObject();
    Key("error");
    text(failure.error);
    Key("message");
    text(failure.message);
    Key("in");
    text(failure.function);
    EndObject();
  }
  template <class T>
  void member(const char* key, const T& content) {
    Key(key);
    value(content);
  }

 private:
  template <class Range>
  void values(const Range& range) {
    StartArray();
    for (const auto& item : range) value(item);
    EndArray();
  }
};

}  // namespace plumbline
