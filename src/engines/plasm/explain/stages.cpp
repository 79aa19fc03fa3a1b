#include "engines/plasm/explain/stages.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "plumbline/error.hpp"

namespace plumbline::plasm {
namespace {

constexpr std::array<std::string_view, 8> kNames = {"transform",        "fragment",   "merge",
                                                    "component filter", "edge order", "face walk",
                                                    "outer face",       "nesting"};

}  // namespace

std::string to_text(Stage stage) { return std::string(kNames.at(static_cast<std::size_t>(stage))); }

Stage stage_of(const std::string& text) {
  const auto found = std::find(kNames.begin(), kNames.end(), text);
  ensure(found != kNames.end(), "an engine is asked about a stage that it has not");
  return static_cast<Stage>(found - kNames.begin());
}

}  // namespace plumbline::plasm
