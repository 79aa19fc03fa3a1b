// Packs arrays of numbers for the page.

#include "output/page/arrays.hpp"

#include <zlib.h>

#include <bit>
#include <limits>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr unsigned kBitsPerByte = 8;

std::uint32_t zigzag(std::uint32_t difference) {
  const std::uint32_t sign = difference >> 31U;
  return (difference << 1U) ^ (0U - sign);
}

std::string deflated(const std::string& bytes) {
  ensure(bytes.size() <= std::numeric_limits<uLong>::max(), "arrays fit zlib's sizes");
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  ensure(status == Z_OK, "zlib compresses into a buffer of its own bound");
  result.resize(size);
  return result;
}

}  // namespace

template <class Word>
void PageArrays::append_planes(const std::vector<Word>& words) {
  bytes_.reserve(bytes_.size() + words.size() * sizeof(Word));
  for (unsigned plane = 0; plane < sizeof(Word); ++plane) {
    for (const Word word : words) {
      bytes_ += static_cast<char>(static_cast<unsigned char>(word >> (plane * kBitsPerByte)));
    }
  }
}

void PageArrays::add(const std::string& name, std::span<const std::uint32_t> values) {
  entries_.push_back({name, "u32", values.size(), "", ""});
  std::vector<std::uint32_t> words;
  words.reserve(values.size());
  std::uint32_t previous = 0;
  for (const std::uint32_t value : values) {
    words.push_back(zigzag(value - previous));
    previous = value;
  }
  append_planes(words);
}

void PageArrays::add(const std::string& name, std::span<const double> values) {
  entries_.push_back({name, "f64", values.size(), "", ""});
  std::vector<std::uint64_t> words;
  words.reserve(values.size());
  for (const double value : values) words.push_back(std::bit_cast<std::uint64_t>(value));
  append_planes(words);
}

void PageArrays::add(const std::string& name, std::span<const double> values,
                     const Reference& reference) {
  ensure(reference.index.size() == values.size(), "each value of an array has its reference");
  entries_.push_back({name, "f64", values.size(), reference.name, reference.index_name});
  std::vector<std::uint64_t> words;
  words.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    words.push_back(std::bit_cast<std::uint64_t>(values[i]) ^
                    std::bit_cast<std::uint64_t>(reference.values[reference.index[i]]));
  }
  append_planes(words);
}

std::string packed(const std::string& bytes) { return base64(deflated(bytes)); }

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3;
  constexpr unsigned kDigitBits = 6, kDigitMask = 63;
  std::string text;
  text.reserve((bytes.size() + 2) / kGroup * 4);
  for (std::size_t i = 0; i < bytes.size(); i += kGroup) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < kGroup; ++k) {
      group = (group << kBitsPerByte) |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k <= kGroup; ++k) {
      text +=
          i + k > bytes.size() ? '=' : kDigits[(group >> (kDigitBits * (kGroup - k))) & kDigitMask];
    }
  }
  return text;
}

}  // namespace plumbline
