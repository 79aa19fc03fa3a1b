#include "cli/losses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kWayOut = "; --lenient goes on without it";

std::string what_of(const Rejected& item) {
  const std::string text = line_text(item.source.element) + ": " + line_text(item.reason);
  return item.text.empty() ? text : text + " (" + line_text(item.text) + ")";
}

}  // namespace

void ensure_all_drawn(const InputArguments& arguments, const std::string& file,
                      const std::vector<Rejected>& rejected, bool is_empty) {
  const std::size_t lost = count_lost(rejected);
  if (arguments.lenient || (lost == 0 && !is_empty)) return;
  const auto worst =
      lost == 0 ? rejected.begin() : std::ranges::find(rejected, false, &Rejected::harmless);
  std::string message =
      is_empty ? "nothing of the file is drawn"
               : fmt::format("not all is drawn: {} item{} that look{} like geometry cannot be read",
                             lost, lost == 1 ? "" : "s", lost == 1 ? "s" : "");
  if (worst == rejected.end()) {
    throw Error(ErrorCode::BadInput, message + ": it has no segments" + kWayOut, {file, 0, 0});
  }
  if (is_empty) message += fmt::format(" ({} rejected)", rejected.size());
  throw Error(ErrorCode::BadInput,
              fmt::format("{}; the first is {}{}", message, what_of(*worst), kWayOut),
              {file, worst->source.line, worst->source.column});
}

void ensure_all_drawn(const InputArguments& arguments, const SegmentSet& input) {
  ensure_all_drawn(arguments, arguments.file, input.rejected,
                   input.segments.empty() && !(input.rejected.empty() && input.labels.empty()));
}

}  // namespace plumbline::cli
