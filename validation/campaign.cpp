// Both exact engines on random inputs of every family, compared member by member; the first case
// that differs is made small and printed. Usage: plumbline_campaign COUNT [FIRST-SEED]

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "plumbline/arrange.hpp"
#include "random_segments.hpp"

using namespace plumbline;

namespace {

bool differ(const SegmentSet& input) {
  return arrange(input, Engine::Bucket) != arrange(input, Engine::Cgal);
}

SegmentSet without(const SegmentSet& input, std::size_t first, std::size_t count) {
  SegmentSet rest;
  const SourceId source = rest.add_source({});
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    if (s < first || s >= first + count) rest.add(input.segments[s], source);
  }
  for (const Point& p : input.points) rest.add_point(p, source);
  return rest;
}

/// A subset of the segments that still differs and of which none can be left out (Zeller and
/// Hildebrandt, "Simplifying and isolating failure-inducing input", 2002).
SegmentSet minimised(SegmentSet input) {
  for (std::size_t count = input.segments.size() / 2; count > 0; count /= 2) {
    for (std::size_t first = 0; first < input.segments.size();) {
      const SegmentSet rest = without(input, first, count);
      if (differ(rest)) {
        input = rest;
      } else {
        first += count;
      }
    }
  }
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const unsigned long first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  if (count == 0) {
    fmt::print(stderr, "usage: plumbline_campaign COUNT [FIRST-SEED]\n");
    return 2;
  }
  const std::size_t families = std::size(random_segments::kFamilies);
  std::size_t edges = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const char* family = random_segments::kFamilies[i % families];
    const auto seed = static_cast<unsigned>(first + i / families);
    const SegmentSet input = random_segments::make(family, seed);
    if (differ(input)) {
      fmt::print("the engines differ: family \"{}\", seed {}; made small:\n", family, seed);
      const SegmentSet small = minimised(input);
      for (const Segment& s : small.segments) fmt::print("{}\n", to_text(s));
      for (const Point& p : small.points) fmt::print("+ {}\n", to_text(p));
      return 1;
    }
    edges += input.segments.size();
  }
  fmt::print("{} inputs of {} families, {} segments: no difference\n", count, families, edges);
  return 0;
}
