#include "check_reader.hpp"

namespace {

plumbline::Structure read(std::string_view text, const std::string& name,
                          const plumbline::ReadOptions& /*options*/) {
  return plumbline::read_lines(text, name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_reader(read, data, size);
  return 0;
}
