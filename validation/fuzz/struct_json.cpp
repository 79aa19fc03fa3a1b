#include <cstdio>
#include <cstdlib>

#include "check_reader.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/structure.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kMaxWords = std::size_t{1} << 18U;

[[noreturn]] void fail(const char* why) {
  std::fprintf(stderr, "broken promise: %s\n", why);
  std::abort();
}

/// A structure that can be used is converted, boxed, and the same after it was written and read.
void use(const Structure& structure) {
  const std::size_t d = dimension(structure);
  const LarModel model = struct_to_lar(structure, {}, kMaxWords);
  check(model);
  const auto found = box(structure);
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    for (std::size_t i = 0; i < d; ++i) {
      if (model.vertex(v)[i] < found->low[i] || model.vertex(v)[i] > found->high[i]) {
        fail("a vertex outside of the box");
      }
    }
  }
  const Structure again = read_struct_json(to_json(structure), "again");
  if (struct_to_lar(again, {}, kMaxWords) != model) fail("another model after writing and reading");
}

}  // namespace
}  // namespace plumbline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumbline::check_reader(plumbline::read_struct_json, data, size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    plumbline::use(plumbline::read_struct_json(text, "fuzz"));
  } catch (const plumbline::Error& error) {
    if (error.code() == plumbline::ErrorCode::Internal) plumbline::fail(error.what());
  }
  return 0;
}
