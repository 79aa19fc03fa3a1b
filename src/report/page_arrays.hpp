#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "write/json_writer.hpp"

namespace plumbline {

/// Arrays of numbers for the page: small once compressed, and read quickly. Each is stored in byte
/// planes, the least significant bytes of all its values first; unsigned integers as differences of
/// successive ones, zigzag (0, -1, 1, -2, ... as 0, 1, 2, 3, ...), modulo 2^32; doubles as their
/// bits, exclusive-or those of a reference array where one is given. `html/arrays.ts` reads them
/// back.
class PageArrays {
 public:
  void add(const std::string& name, std::span<const std::uint32_t> values);
  /// `reference` is the name of an array added before, of the same length, and its values.
  struct Reference {
    std::string name;
    std::span<const double> values;
  };
  void add(const std::string& name, std::span<const double> values);
  void add(const std::string& name, std::span<const double> values, const Reference& reference);

  /// The array of {name, type, count, reference} in their order.
  void write_directory(JsonWriter& json) const;
  /// The arrays one after the other, compressed by zlib, in base64.
  std::string packed() const;

 private:
  struct Entry {
    std::string name;
    const char* type;
    std::size_t count;
    std::string reference;
  };
  template <class Word>
  void append_planes(const std::vector<Word>& words);

  std::vector<Entry> entries_;
  std::string bytes_;
};

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace plumbline
