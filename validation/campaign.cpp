// Both exact engines on random inputs of every family, compared member by member, and the bucket
// engine with itself: the input shuffled and turned round, on three threads. The first case that
// differs is made small and printed. Usage: plumbline_campaign COUNT [FIRST-SEED]

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>

#include "plumbline/arrange.hpp"
#include "random_segments.hpp"

using namespace plumbline;

namespace {

/// A copy of the input with its segments in another order and every other one reversed, and where
/// each was.
struct Disguised {
  SegmentSet input;
  std::vector<SegmentId> original;
};

Disguised disguised(const SegmentSet& input) {
  std::vector<std::size_t> order(input.segments.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  Disguised result;
  const SourceId source = result.input.add_source({});
  for (const std::size_t s : order) {
    const Segment segment = input.segments[s];
    result.input.add(s % 2 == 0 ? segment : Segment{segment.b, segment.a}, source);
    result.original.emplace_back(s);
  }
  for (std::size_t p = input.points.size(); p-- > 0;) {
    result.input.add_point(input.points[p], source);
  }
  return result;
}

/// What the bucket engine returns for the input in disguise, the segments called by their old ids.
ExactComplex seen_through(const Disguised& disguise) {
  ExactComplex complex = arrange(disguise.input, Engine::Bucket, {3, {}});
  Lists<SegmentId> sources;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    std::vector<SegmentId> ids;
    for (const SegmentId s : complex.edge_sources[e]) ids.push_back(disguise.original[s]);
    std::sort(ids.begin(), ids.end());
    sources.push_back(ids);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

/// What is wrong with the bucket engine's result; empty if nothing.
std::string difference(const SegmentSet& input) {
  const ExactComplex complex = arrange(input, Engine::Bucket, {1, {}});
  if (complex != arrange(input, Engine::Cgal)) return "the engines differ";
  if (complex != seen_through(disguised(input))) return "order or threads change the result";
  return "";
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

/// A subset of the segments that is still wrong and of which none can be left out (Zeller and
/// Hildebrandt, "Simplifying and isolating failure-inducing input", 2002).
SegmentSet minimised(SegmentSet input) {
  for (std::size_t count = input.segments.size() / 2; count > 0; count /= 2) {
    for (std::size_t first = 0; first < input.segments.size();) {
      const SegmentSet rest = without(input, first, count);
      if (!difference(rest).empty()) {
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
  const std::vector<std::string>& families = random_segments::families();
  std::size_t segments = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::string& family = families[i % families.size()];
    const auto seed = static_cast<unsigned>(first + i / families.size());
    const SegmentSet input = random_segments::make(family, seed);
    if (const std::string wrong = difference(input); !wrong.empty()) {
      fmt::print("{}: family \"{}\", seed {}; made small:\n", wrong, family, seed);
      const SegmentSet small = minimised(input);
      for (const Segment& s : small.segments) fmt::print("{}\n", to_text(s));
      for (const Point& p : small.points) fmt::print("+ {}\n", to_text(p));
      return 1;
    }
    segments += input.segments.size();
  }
  fmt::print("{} inputs of {} families, {} segments: no difference\n", count, families.size(),
             segments);
  return 0;
}
