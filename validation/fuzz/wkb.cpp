#include "check_reader.hpp"
#include "check_streamed.hpp"

namespace {

plumbline::Structure read(std::string_view text, const std::string& name,
                          const plumbline::ReadOptions& /*options*/) {
  return plumbline::read_wkb(text, name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_reader(read, data, size);
  plumbline::check_streamed([](plumbline::ByteStream& bytes) { return plumbline::read_wkb(bytes); },
                            plumbline::read_wkb, data, size);
  return 0;
}
