#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Arrays of numbers for the page: small once compressed, and read quickly. Each is stored in byte
/// planes, the least significant bytes of all its values first; unsigned integers as differences of
/// successive ones, zigzag (0, -1, 1, -2, ... as 0, 1, 2, 3, ...), modulo 2^32; doubles as their
/// bits, exclusive-or those of like values of another array where such are given.
/// `src/web/arrays.ts` reads them back.
class PageArrays {
 public:
  /// Per value the index of a like one in an array of doubles; arrays of both are added before.
  struct Reference {
    std::string name;
    std::span<const double> values;
    std::string index_name;
    std::span<const std::uint32_t> index;
  };
  void add(const std::string& name, std::span<const std::uint32_t> values);
  void add(const std::string& name, std::span<const double> values);
  void add(const std::string& name, std::span<const double> values, const Reference& reference);

  /// An array, as the page finds it; the latter two may be "".
  struct Entry {
    std::string name;
    const char* type;
    std::size_t count;
    std::string reference, index;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  /// The arrays one after the other.
  const std::string& bytes() const { return bytes_; }

 private:
  template <class Word>
  void append_planes(const std::vector<Word>& words);

  std::vector<Entry> entries_;
  std::string bytes_;
};

/// The bytes compressed by zlib, in base64: nothing in them can be taken for markup.
std::string packed(const std::string& bytes);
/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace plumbline
