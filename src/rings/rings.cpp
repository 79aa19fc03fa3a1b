// Polygon by polygon: single rings, where rings meet, which lies in which.

#include "plumbline/rings.hpp"

#include <algorithm>
#include <tuple>

#include "rings/steps.hpp"

namespace plumbline {
namespace rings {

std::vector<SegmentId> segments_of(const Shape& shape, std::size_t ring, std::size_t other,
                                   std::span<const EdgeId> edges) {
  std::vector<SegmentId> result;
  const auto is_of = [&](SegmentId s, std::size_t r) {
    const Ring& of = shape.input.rings[r];
    return s >= of.first && s - of.first < of.count;
  };
  for (const EdgeId e : edges) {
    for (const SegmentId s : shape.complex.edge_sources[e]) {
      if (is_of(s, ring) || is_of(s, other)) result.push_back(s);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

namespace {

constexpr std::size_t kFewestSegments = 3;

/// What a single ring tells; whether it goes on to be looked at.
bool look_at_ring(const SegmentSet& input, std::size_t index, const Walk& walk,
                  std::vector<RingProblem>& problems) {
  const Ring& ring = input.rings[index];
  const std::size_t last = ring.first + ring.count - 1;
  RingProblem problem{RingFault::NotClosed, index, index, input.segments[last].b, std::nullopt, {}};
  if (!walk.is_closed) {
    problem.segments = {SegmentId(ring.first), SegmentId(last)};
    if (ring.count == 1) problem.segments.pop_back();
    problems.push_back(std::move(problem));
    return true;
  }
  // A line that is drawn there and back is none of a polygon.
  if (ring.count >= kFewestSegments) return true;
  if (ring.role == RingRole::Line) return false;
  problem.fault = RingFault::TooFewPoints;
  for (std::size_t s = ring.first; s <= last; ++s) problem.segments.emplace_back(s);
  problems.push_back(std::move(problem));
  return false;
}

/// A ring of which nothing is left, beside one of the same polygon of which there is.
void look_at_empty_ring(const SegmentSet& input, std::size_t index, std::size_t other,
                        std::vector<RingProblem>& problems) {
  const std::size_t s = input.rings[other].first;
  problems.push_back(
      {RingFault::TooFewPoints, index, other, input.segments[s].a, std::nullopt, {SegmentId(s)}});
}

/// The rings from `begin` to `end`.
void look_at_polygon(const SegmentSet& input, const ExactComplex& complex, const Walks& walks,
                     std::size_t begin, std::size_t end, std::vector<RingProblem>& problems) {
  const auto first = static_cast<std::ptrdiff_t>(problems.size());
  Shape shape{input, complex, {}, {}};
  std::size_t part = 0;
  const auto is_there = [&](const Ring& ring) { return ring.count > 0; };
  const auto some = std::find_if(input.rings.begin() + static_cast<std::ptrdiff_t>(begin),
                                 input.rings.begin() + static_cast<std::ptrdiff_t>(end), is_there);
  const auto there = static_cast<std::size_t>(some - input.rings.begin());
  if (there == end) return;
  for (std::size_t i = begin; i < end; ++i) {
    if (input.rings[i].role != RingRole::Hole) part = shape.walks.size();
    if (input.rings[i].count == 0) {
      look_at_empty_ring(input, i, there, problems);
      continue;
    }
    Walk walk = walks.of(i);
    if (!look_at_ring(input, i, walk, problems)) continue;
    shape.walks.push_back(std::move(walk));
    shape.parts.push_back(part);
  }
  Meetings found = meetings(shape);
  std::vector<RingProblem> further = nesting(shape, found);
  std::move(found.problems.begin(), found.problems.end(), std::back_inserter(problems));
  std::move(further.begin(), further.end(), std::back_inserter(problems));
  std::sort(problems.begin() + first, problems.end(),
            [](const RingProblem& a, const RingProblem& b) {
              return std::tie(a.fault, a.where, a.ring, a.other) <
                     std::tie(b.fault, b.where, b.ring, b.other);
            });
}

}  // namespace
}  // namespace rings

std::vector<RingProblem> ring_problems(const SegmentSet& input, const ExactComplex& complex) {
  std::vector<RingProblem> problems;
  if (input.rings.empty()) return problems;
  const rings::Walks walks(input, complex);
  const auto goes_on = [&](std::size_t i) {
    const RingRole role = input.rings[i].role;
    return role == RingRole::Hole || role == RingRole::Part;
  };
  for (std::size_t begin = 0, end = 0; begin < input.rings.size(); begin = end) {
    end = begin + 1;
    while (end < input.rings.size() && goes_on(end)) ++end;
    rings::look_at_polygon(input, complex, walks, begin, end, problems);
  }
  return problems;
}

}  // namespace plumbline
