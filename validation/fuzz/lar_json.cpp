#include "check_reader.hpp"
#include "check_streamed.hpp"

namespace {

plumbline::Structure read(std::string_view text, const std::string& name,
                          const plumbline::ReadOptions& /*options*/) {
  return plumbline::read_lar_json(text, name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_reader(read, data, size);
  plumbline::check_streamed(
      [](plumbline::ByteStream& bytes) { return plumbline::read_lar_json(bytes); },
      plumbline::read_lar_json, data, size);
  return 0;
}
