// What the texts for a terminal have in common.

#include "output/text/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownInputs = 3;

}  // namespace

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string input_lines(const SegmentSet& input, const std::vector<SegmentId>& segments,
                        std::string_view indent) {
  const std::vector<SourceId> sources = sources_of(input, segments);
  const std::size_t shown = std::min(sources.size(), kShownInputs);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    text +=
        fmt::format("{}{}\n", indent, line_text(to_text(input.sources[sources[i]], input.files)));
  }
  if (shown < sources.size()) {
    text += fmt::format("{}and {} more\n", indent, sources.size() - shown);
  }
  return text;
}

}  // namespace plumbline
