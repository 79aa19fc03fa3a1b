#include "check_streamed.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "check_reader.hpp"

namespace plumbline {
namespace {

constexpr const char* kFile = "fuzz";
constexpr std::size_t kSmallBlock = 7;

/// What a reader made of an input, or the error that it threw, without the text that follows.
struct Outcome {
  Structure structure;
  std::string error;
};

template <class Reader>
Outcome outcome(Reader reader) {
  try {
    return {reader(), {}};
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Internal) throw;
    return {{}, to_text(error.place()) + ": " + error.message()};
  }
}

[[noreturn]] void fail(const std::string& text, const std::string& blocks) {
  std::fprintf(stderr, "broken promise: as a text \"%s\", in blocks \"%s\"\n", text.c_str(),
               blocks.c_str());
  std::abort();
}

}  // namespace

void check_streamed(Structure (*read)(ByteStream&, const FeatureOptions&),
                    Structure (*read_text)(std::string_view, const std::string&,
                                           const ReadOptions&),
                    const std::uint8_t* data, std::size_t size) {
  check_reader(read_text, data, size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Outcome as_text = outcome([&] { return read_text(text, kFile, {}); });
  const Outcome in_blocks = outcome([&] {
    ByteStream bytes(std::make_unique<std::istringstream>(std::string(text)), kFile, kSmallBlock);
    return read(bytes, {});
  });
  if (as_text.error != in_blocks.error) fail(as_text.error, in_blocks.error);
  if (as_text.structure != in_blocks.structure) fail("one structure", "another");
}

}  // namespace plumbline
