#include "check_streamed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_streamed(plumbline::read_geojson, plumbline::read_geojson, data, size);
  return 0;
}
