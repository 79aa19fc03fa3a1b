// Small damaged drawings, repaired and held against what is promised. Prints a table and what is
// wrong, the first of it made small. Exit code 1 if something is. Usage: plumbline_repair_fuzz
// COUNT [FIRST-SEED [MOST-SMALL [WEAK]]]; with WEAK also what was given up counts as wrong.

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "campaign/minimise.hpp"
#include "plumbline/error.hpp"
#include "repair/promises.hpp"

using namespace plumbline;
using namespace plumbline::repairs;

namespace {

constexpr unsigned long kMostSmall = 10;
constexpr std::size_t kMostTries = 500;

std::string options_text(const RepairOptions& options) {
  std::string result;
  const auto add = [&](const char* name, const std::optional<Rational>& value) {
    if (value) result += fmt::format(" --{} {}", name, exact_text(*value));
  };
  add("weld", options.weld);
  add("grow", options.grow);
  add("trim", options.trim);
  add("sliver", options.sliver);
  add("snap", options.snap);
  add("simplify", options.simplify);
  if (options.doors) {
    result += fmt::format(" --doors {}..{}", exact_text(options.doors->least),
                          exact_text(options.doors->most));
  }
  if (!options.anchors.empty()) result += " --anchor " + options.anchors.front();
  return result;
}

std::string kind_of(const Verdict& verdict, bool with_weak) {
  if (verdict.broken == "throws") return "throws: " + verdict.detail;
  if (!verdict.broken.empty()) return verdict.broken;
  if (with_weak && verdict.given_up > 0) return "an operation was given up";
  if (with_weak && verdict.stayed > 0) return "a weld was given up";
  return {};
}

SegmentSet without(const SegmentSet& set, std::size_t left_out) {
  SegmentSet result = set;
  result.segments = {};
  result.segment_source.clear();
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    if (i == left_out) continue;
    result.add(set.segments[i], set.segment_source[i]);
  }
  return result;
}

/// The trial with fewer segments, simpler numbers and fewer tolerances that fails the same way.
Trial made_small(Trial trial, const std::string& kind) {
  const auto fails = [&](const Trial& other) { return kind_of(judged(other), true) == kind; };
  const auto try_options = [&](const auto& change) {
    Trial other = trial;
    change(other.options);
    if (fails(other)) trial = std::move(other);
  };
  try_options([](RepairOptions& o) { o.anchors.clear(); });
  try_options([](RepairOptions& o) { o.doors.reset(); });
  try_options([](RepairOptions& o) { o.snap = 0; });
  try_options([](RepairOptions& o) { o.simplify = 0; });
  try_options([](RepairOptions& o) { o.sliver = 0; });
  try_options([](RepairOptions& o) { o.trim = 0; });
  try_options([](RepairOptions& o) { o.grow = 0; });
  try_options([](RepairOptions& o) { o.weld = 0; });
  const RepairOptions options = trial.options;
  std::size_t tries = 0;
  const auto set_fails = [&](const SegmentSet& set) {
    return ++tries < kMostTries && fails({set, options});
  };
  for (std::size_t i = trial.drawing.segments.size(); i-- > 0;) {
    SegmentSet fewer = without(trial.drawing, i);
    if (set_fails(fewer)) trial.drawing = std::move(fewer);
  }
  // This leaves out layers.
  if (set_fails(campaign::minimised(trial.drawing, [](const SegmentSet&) { return false; }))) {
    trial.drawing = campaign::minimised(trial.drawing, set_fails);
  }
  return trial;
}

void show(const std::string& kind, const Trial& trial) {
  const Trial small = made_small(trial, kind);
  const Verdict verdict = judged(small);
  fmt::print(stderr, "# {} {}\n# plumbline repair{}\n", kind, verdict.detail,
             options_text(small.options));
  for (std::size_t i = 0; i < small.drawing.segments.size(); ++i) {
    const Segment s = small.drawing.segments[i];
    const Source source = small.drawing.sources[small.drawing.segment_source[i]];
    fmt::print(stderr, "{},{},{},{}{}\n", exact_text(s.a.x), exact_text(s.a.y), exact_text(s.b.x),
               exact_text(s.b.y), source.layer.empty() ? "" : " # anchored");
  }
}

struct Totals {
  std::size_t edits = 0, refused = 0, stayed = 0, given_up = 0, untouched = 0, wrong = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const unsigned long first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const unsigned long most_small = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : kMostSmall;
  const bool with_weak = argc > 4;
  if (count == 0) {
    fmt::print(stderr, "usage: plumbline_repair_fuzz COUNT [FIRST-SEED [MOST-SMALL [WEAK]]]\n");
    return 2;
  }
  Totals totals;
  std::size_t shown = 0;
  for (unsigned long seed = first; seed < first + count; ++seed) {
    const Trial drawn = trial(seed);
    const Verdict verdict = judged(drawn);
    totals.edits += verdict.edits;
    totals.untouched += verdict.edits == 0 ? 1 : 0;
    totals.refused += verdict.refused > 0 ? 1 : 0;
    totals.stayed += verdict.stayed > 0 ? 1 : 0;
    totals.given_up += verdict.given_up > 0 ? 1 : 0;
    totals.wrong += verdict.broken.empty() ? 0 : 1;
    const std::string kind = kind_of(verdict, with_weak);
    if (kind.empty()) continue;
    fmt::print(stderr, "seed {}: {}; {}\n", seed, kind, verdict.detail);
    if (++shown <= most_small) show(kind, drawn);
  }
  fmt::print(
      "| drawings | edits | without an edit | with something refused | with welds given up | "
      "with an operation given up as a whole | promises broken |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- |\n| {} | {} | {} | {} | {} | {} | {} |\n",
             count, totals.edits, totals.untouched, totals.refused, totals.stayed, totals.given_up,
             totals.wrong);
  return totals.wrong == 0 ? 0 : 1;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
