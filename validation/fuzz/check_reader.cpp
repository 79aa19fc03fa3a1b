#include "check_reader.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr const char* kFile = "fuzz";
/// Far less than the default, so that a run of a fuzzer makes thousands of inputs.
constexpr std::size_t kMaxWords = std::size_t{1} << 20U;

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "broken promise: %s\n", why.c_str());
  std::abort();
}

/// The length of the UTF-8 character that the text starts with; 0 where it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80U   ? 1
                             : lead < 0xc2U ? 0
                             : lead < 0xe0U ? 2
                             : lead < 0xf0U ? 3
                             : lead < 0xf5U ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
  }
  if (length < 3) return length;
  const bool is_overlong = (lead == 0xe0U && byte(1) < 0xa0U) || (lead == 0xf0U && byte(1) < 0x90U);
  const bool is_surrogate = lead == 0xedU && byte(1) >= 0xa0U;
  const bool is_beyond = lead == 0xf4U && byte(1) >= 0x90U;
  return is_overlong || is_surrogate || is_beyond ? 0 : length;
}

void check_text(std::string_view text, const char* what) {
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = character_length(rest);
    if (length == 0) fail(std::string(what) + " is not UTF-8: " + std::string(text));
    if (static_cast<unsigned char>(rest[0]) < ' ') {
      fail(std::string(what) + " has a control character");
    }
    rest.remove_prefix(length);
  }
}

void check_source(const Source& source, const SegmentSet& set) {
  if (source.file >= set.files.size()) fail("a source in a file that is not there");
  check_text(source.element, "an element");
  check_text(source.id, "an id");
  check_text(source.path, "a path");
}

void check_set(const SegmentSet& set) {
  for (const Source& source : set.sources) check_source(source, set);
  for (const Rejected& item : set.rejected) {
    check_source(item.source, set);
    if (item.reason.empty()) fail("a rejected item without a reason");
    check_text(item.reason, "a reason");
    check_text(item.text, "an offending text");
  }
  for (const Replacement& item : set.ledger) {
    check_source(item.source, set);
    if (item.what.empty() || item.bound.empty()) fail("an empty entry in the ledger");
    check_text(item.what, "an entry of the ledger");
  }
}

using Read = std::function<Structure(std::string_view)>;

void check_result(const Read& read, const std::uint8_t* data, std::size_t size) {
  try {
    const Structure structure = read({reinterpret_cast<const char*>(data), size});
    check_set(evaluate(structure, {kMaxWords}));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Internal) fail(error.what());
    check_text(error.what(), "an error");
  }
}

}  // namespace

void check_reader(Structure (*read)(std::string_view, const std::string&, const ReadOptions&),
                  const std::uint8_t* data, std::size_t size) {
  for (const bool is_set : {false, true}) {
    ReadOptions options;
    options.hidden = options.shortest_decimals = is_set;
    check_result([&](std::string_view text) { return read(text, kFile, options); }, data, size);
  }
}

}  // namespace plumbline
