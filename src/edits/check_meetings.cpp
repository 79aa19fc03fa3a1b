// Where a line that was moved meets another one, segments that they stand for met, too, as near as
// lines move; or one of them ends so near, or grew there; or vertices were snapped together. So
// lines that run past each other do not come to cross. Of lines that were not moved the other steps
// know all: they are where they were authored, or added.

#include <algorithm>
#include <optional>

#include "edits/moves.hpp"
#include "edits/steps.hpp"

namespace plumbline::edits {
namespace {

/// Output segments that lie on one line at a vertex, taken together.
struct Bundle {
  Segment extent;
  std::vector<SegmentId> origins;
};

/// Per vertex of the arrangement at which a moved segment is, the edges there.
std::vector<std::vector<EdgeId>> edges_at_moved(const Repair& repair, const ExactComplex& after,
                                                const Moves& moves) {
  std::vector<std::vector<EdgeId>> result(after.vertices.size());
  std::vector<bool> is_asked(after.vertices.size(), false);
  for (std::size_t e = 0; e < after.edge_count(); ++e) {
    const auto is_moved = [&](SegmentId i) { return moves.is_moved(repair.origins[i]); };
    if (!std::ranges::any_of(after.edge_sources[e], is_moved)) continue;
    is_asked[after.edges[e].tail] = is_asked[after.edges[e].head] = true;
  }
  for (std::size_t e = 0; e < after.edge_count(); ++e) {
    for (const VertexId v : {after.edges[e].tail, after.edges[e].head}) {
      if (is_asked[v]) result[v].push_back(EdgeId(e));
    }
  }
  return result;
}

std::vector<Bundle> bundles_at(const Repair& repair, const ExactComplex& after,
                               std::span<const EdgeId> edges) {
  std::vector<SegmentId> segments;
  for (const EdgeId e : edges) {
    segments.insert(segments.end(), after.edge_sources[e].begin(), after.edge_sources[e].end());
  }
  std::ranges::sort(segments);
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  std::vector<Bundle> result;
  for (const SegmentId i : segments) {
    if (repair.origins[i].empty()) continue;  // virtual
    const Segment extent = repair.output.segments[i];
    auto place = std::ranges::find_if(
        result, [&](const Bundle& bundle) { return is_collinear(bundle.extent, extent); });
    if (place == result.end()) place = result.insert(place, {extent, {}});
    for (const SegmentId s : repair.origins[i]) place->origins.push_back(s);
  }
  return result;
}

/// The squared distance of the point from what the segments have in common.
std::optional<Rational> distance_from_meeting(const Point& p, const Segment& s, const Segment& t) {
  if (is_collinear(s, t)) {
    const Segment u = ordered(s), v = ordered(t);
    const Point low = std::max(u.a, v.a), high = std::min(u.b, v.b);
    if (high < low) return {};
    return squared_distance(p, low, high);
  }
  const std::optional<Point> meeting = crossing(s, t);
  if (!meeting) return {};
  return squared_distance(p, *meeting);
}

/// The segments of a bundle that pass so near.
std::vector<SegmentId> passing(const SegmentSet& input, const Point& p, const Bundle& bundle,
                               const Rational& squared_bound) {
  std::vector<SegmentId> result = bundle.origins;
  std::erase_if(result, [&](SegmentId s) {
    const Segment segment = input.segments[s];
    return squared_distance(p, segment.a, segment.b) > squared_bound;
  });
  return result;
}

bool met(const SegmentSet& input, const Point& p, const Bundle& b, const Bundle& c,
         const Rational& squared_bound) {
  const std::vector<SegmentId> others = passing(input, p, c, squared_bound);
  for (const SegmentId s : passing(input, p, b, squared_bound)) {
    for (const SegmentId t : others) {
      const auto moved = distance_from_meeting(p, input.segments[s], input.segments[t]);
      if (s == t || (moved && *moved <= squared_bound)) return true;
    }
  }
  return false;
}

bool is_added_near(const Moves& moves, const Point& p, const Bundle& bundle,
                   const Rational& squared_bound) {
  return std::ranges::any_of(moves.added_to(bundle.origins), [&](const Segment& piece) {
    return squared_distance(p, piece.a, piece.b) <= squared_bound;
  });
}

/// Whether what was drawn for the bundle begins, ends or was added so near.
bool ends_near(const SegmentSet& input, const Moves& moves, const Point& p, const Bundle& bundle,
               const Rational& squared_bound) {
  for (const SegmentId s : bundle.origins) {
    const Segment segment = input.segments[s];
    if (squared_distance(p, segment.a) <= squared_bound) return true;
    if (squared_distance(p, segment.b) <= squared_bound) return true;
  }
  return is_added_near(moves, p, bundle, squared_bound);
}

bool is_right(const SegmentSet& input, const Moves& moves, const Point& p, const Bundle& b,
              const Bundle& c) {
  if (!moves.is_moved(b.origins) && !moves.is_moved(c.origins)) return true;
  std::vector<SegmentId> both = b.origins;
  both.insert(both.end(), c.origins.begin(), c.origins.end());
  const Rational bound = moves.bound(both), squared = bound * bound;
  // Vertices that are near each other become one by snapping, whatever leads through them.
  if (moves.is_snapped(both)) {
    const auto is_near = [&](const Bundle& bundle) {
      return !passing(input, p, bundle, squared).empty() ||
             is_added_near(moves, p, bundle, squared);
    };
    return is_near(b) && is_near(c);
  }
  return met(input, p, b, c, squared) || ends_near(input, moves, p, b, squared) ||
         ends_near(input, moves, p, c, squared);
}

}  // namespace

std::vector<Breach> check_meetings(const SegmentSet& input, const Repair& repair,
                                   const ExactComplex& after) {
  std::vector<Breach> result;
  const Moves moves(repair);
  if (!moves.is_any()) return result;
  const std::vector<std::vector<EdgeId>> edges = edges_at_moved(repair, after, moves);
  for (std::size_t v = 0; v < edges.size(); ++v) {
    if (edges[v].size() < 2) continue;
    const std::vector<Bundle> bundles = bundles_at(repair, after, edges[v]);
    const Point p = after.vertices[v];
    for (std::size_t i = 0; i < bundles.size(); ++i) {
      for (std::size_t j = i + 1; j < bundles.size(); ++j) {
        if (is_right(input, moves, p, bundles[i], bundles[j])) continue;
        result.push_back({"a line that was moved meets one that it did not meet: segments " +
                              std::to_string(bundles[i].origins.front()) + " and " +
                              std::to_string(bundles[j].origins.front()) + " of the input",
                          p,
                          {}});
      }
    }
  }
  return result;
}

}  // namespace plumbline::edits
