// Compressed SVG: the bytes are inflated, however they are damaged, and what comes out is read.

#include "check_reader.hpp"
#include "read/gzip.hpp"

namespace {

constexpr std::size_t kMaxText = std::size_t{1} << 16U;  // far less than the default, for speed

plumbline::Structure read(std::string_view bytes, const std::string& name,
                          const plumbline::ReadOptions& options) {
  return plumbline::read_svg(plumbline::inflated(bytes, name, kMaxText), name, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_reader(read, data, size);
  return 0;
}
