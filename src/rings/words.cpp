// The names of faults and a sentence on each.

#include <array>
#include <string>

#include "plumbline/rings.hpp"

namespace plumbline {
namespace {

struct Names {
  const char *own, *of_jts;
};
constexpr std::array<Names, kRingFaults> kNames{{
    {"ring not closed", "Ring is not closed"},
    {"too few points", "Too few points in geometry component"},
    {"crossing", "Self-intersection"},
    {"runs along", "Self-intersection"},
    {"touches itself", "Ring Self-intersection"},
    {"hole outside", "Hole lies outside shell"},
    {"nested holes", "Holes are nested"},
    {"nested parts", "Nested shells"},
    {"disconnected interior", "Interior is disconnected"},
}};

/// "outer ring", "outer ring of part 2", "hole 1", "hole 3 of part 2", "closed line".
std::string name_of(std::size_t index, const SegmentSet& input) {
  if (input.rings[index].role == RingRole::Line) return "closed line";
  std::size_t holes = 0, parts = 1;
  bool is_own_part = true;  // whether the part of the ring still goes on
  for (std::size_t i = index;; --i) {
    const RingRole role = input.rings[i].role;
    if (role == RingRole::Hole && is_own_part) ++holes;
    if (role != RingRole::Hole) is_own_part = false;
    if (role == RingRole::Part) ++parts;
    if (role == RingRole::Polygon || role == RingRole::Line || i == 0) break;
  }
  const bool has_parts = parts > 1 || [&] {
    for (std::size_t i = index + 1; i < input.rings.size(); ++i) {
      if (input.rings[i].role != RingRole::Hole) return input.rings[i].role == RingRole::Part;
    }
    return false;
  }();
  std::string name = holes > 0 ? "hole " + std::to_string(holes) : "outer ring";
  return has_parts ? name + " of part " + std::to_string(parts) : name;
}

std::string source_of(std::size_t index, const SegmentSet& input) {
  const std::size_t segment = input.rings[index].first;
  if (segment >= input.segment_source.size()) return {};
  const Source source = input.sources[input.segment_source[segment]];
  if (source.element.empty() && source.id.empty()) return {};
  std::string text = " of " + source.element;
  if (!source.id.empty()) text += (source.element.empty() ? "#" : " #") + source.id;
  return text;
}

}  // namespace

std::string to_text(RingFault fault) { return kNames[static_cast<std::size_t>(fault)].own; }
std::string jts_name(RingFault fault) { return kNames[static_cast<std::size_t>(fault)].of_jts; }

std::string describe(const RingProblem& problem, const SegmentSet& input) {
  const bool is_there = input.rings[problem.ring].count > 0;
  const std::string ring =
      name_of(problem.ring, input) + source_of(is_there ? problem.ring : problem.other, input);
  std::string other = problem.ring == problem.other ? "itself" : name_of(problem.other, input);
  if (other.starts_with("outer")) other = "the " + other;
  switch (problem.fault) {
    case RingFault::NotClosed:
      return ring + " is not closed";
    case RingFault::TooFewPoints:
      return ring + " has less than three distinct points";
    case RingFault::Crosses:
      return ring + " crosses " + other;
    case RingFault::RunsAlong:
      return ring + " runs along " + other;
    case RingFault::Touches:
      return ring + " touches itself";
    case RingFault::HoleOutside:
      return ring + " lies outside " + other;
    case RingFault::NestedHoles:
    case RingFault::NestedParts:
      return ring + " lies in " + other;
    case RingFault::Disconnected:
      return ring + " and " + other + " cut the interior in two";
  }
  return {};
}

}  // namespace plumbline
