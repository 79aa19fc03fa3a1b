// Matches faces by their outer boundaries, and the rest by what they cover. Each step gives groups
// of faces that correspond; the next one goes on with the faces that are in no group yet.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "compare/overlay.hpp"
#include "compare/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Groups = std::vector<Group>;
/// The faces of both sides that are in no group, ascending.
using OpenFaces = Both<std::vector<std::size_t>>;

OpenFaces faces_without(const Sides& sides, const Groups& groups) {
  OpenFaces open;
  for (const Side side : kBothSides) {
    std::vector<bool> has_group(sides[side].face_count());
    for (const Group& group : groups) {
      for (const std::size_t f : group[side]) has_group[f] = true;
    }
    for (std::size_t f = 0; f < has_group.size(); ++f) {
      if (!has_group[f]) open[side].push_back(f);
    }
  }
  return open;
}

bool has_both_sides(const Group& group) { return !group[Exact].empty() && !group[Float].empty(); }

void append(Groups& groups, const Groups& more) {
  std::copy_if(more.begin(), more.end(), std::back_inserter(groups), has_both_sides);
}

/// A cell of the side and one of the other side, the exact one first.
std::pair<std::size_t, std::size_t> pair_of(Side side, std::size_t here, std::size_t there) {
  return side == Exact ? std::pair(here, there) : std::pair(there, here);
}

/// Pairs of open faces whose outer boundaries are the same, but for merged and split cells. Exact
/// faces first, so that pairs with equal boundaries come in their order.
Pairs boundary_pairs(const Sides& sides, const CycleMatch& cycles, const OpenFaces& open) {
  Pairs result;
  for (const Side side : kBothSides) {
    for (const std::size_t f : open[side]) {
      const CycleId cycle = cycles.same[side][sides[side].face_outer[f]];
      if (!cycle.valid()) continue;
      const ExactComplex& others = sides[other(side)];
      const std::size_t g = others.cycle_face[cycle];
      const auto& open_there = open[other(side)];
      const bool is_open = std::binary_search(open_there.begin(), open_there.end(), g);
      if (is_open && others.face_outer[g] == cycle) result.push_back(pair_of(side, f, g));
    }
  }
  return result;
}

/// The faces with the same outer boundary, edge by edge, as groups of one face of each side.
Groups same_boundaries(const Sides& sides, const CycleMatch& cycles, const OpenFaces& open) {
  Groups result;
  Both<std::vector<bool>> has_group{std::vector<bool>(sides[Exact].face_count()),
                                    std::vector<bool>(sides[Float].face_count())};
  for (const auto& [f, g] : boundary_pairs(sides, cycles, open)) {
    if (!cycles.is_one_to_one[sides[Exact].face_outer[f]]) continue;
    if (has_group[Exact][f] || has_group[Float][g]) continue;
    has_group[Exact][f] = has_group[Float][g] = true;
    result.push_back({{{f}, {g}}});
  }
  return result;
}

/// How the open faces overlap: not at all where one side has none. Nothing where `overlay` gives
/// nothing: then faces correspond by their boundaries only.
std::optional<Overlaps> overlaps_of(const Sides& sides, const OpenFaces& open,
                                    bool float_is_valid) {
  if (open[Exact].empty() || open[Float].empty()) return Overlaps({});
  std::optional<std::vector<Region>> regions = overlay(sides, open, float_is_valid);
  if (!regions) return std::nullopt;
  return Overlaps(std::move(*regions));
}

/// The overlaps of the faces that differ; without detail of those without a group, which decide
/// what corresponds; or none.
std::optional<Overlaps> overlaps_wanted(const Sides& sides, const OpenFaces& differing,
                                        const OpenFaces& open, bool float_is_valid, Detail detail) {
  if (detail == Detail::ExactCellsOnly) return Overlaps({});
  if (detail == Detail::Full) return overlaps_of(sides, differing, float_is_valid);
  if (!can_be_overlaid(sides, differing)) return std::nullopt;
  return overlaps_of(sides, open, float_is_valid);
}

/// A point inside a face, and the face of the other side there; invalid if there is none.
struct Place {
  Point inside;
  FaceId there;
};
using Places = Both<std::map<std::size_t, Place>>;  ///< by face

/// Locates a point inside each open face on the other side. Those without interior are left out,
/// which are in an invalid complex only.
Places places_of(const Sides& sides, const OpenFaces& open, bool float_is_valid) {
  Places places;
  for (const Side side : kBothSides) {
    std::vector<std::size_t> faces;
    std::vector<Point> points;
    for (const std::size_t f : open[side]) {
      try {
        points.push_back(interior_point(sides[side], FaceId(f)));
      } catch (const Error&) {
        if (side == Exact || float_is_valid) throw;
        continue;
      }
      faces.push_back(f);
    }
    const std::vector<FaceId> there = locate_all(sides[other(side)], points);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      places[side].emplace(faces[i], Place{points[i], there[i]});
    }
  }
  return places;
}

/// The area of the symmetric difference; that of a face on its own is by the shoelace formula.
std::optional<Rational> area_in_dispute(const Sides& sides, const std::optional<Overlaps>& overlaps,
                                        const Group& group) {
  if (has_both_sides(group)) {
    if (!overlaps) return std::nullopt;
    return overlaps->symmetric_difference(group);
  }
  Rational area = 0;
  for (const Side side : kBothSides) {
    for (const std::size_t f : group[side]) area += abs(face_area(sides[side], FaceId(f)));
  }
  return area;
}

/// Earlier findings that explain a disagreement, and the edges that they are about.
struct Cause {
  Numbers numbers;
  Both<std::vector<EdgeId>> edges;
};

/// By the edges of the outer boundaries that disagree; where there are none, by the vertices (two
/// vertices that became one can close a face or take it apart).
Cause cause_of(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
               const Group& group) {
  Cause by_edges, by_vertices, unknown;
  for (const Side side : kBothSides) {
    for (const std::size_t f : group[side]) {
      for (const HalfedgeId h : sides[side].cycles[sides[side].face_outer[f]]) {
        const EdgeId e = edge_of(h);
        unknown.edges[side].push_back(e);
        if (edges.number[side][e] != 0) {
          by_edges.numbers.push_back(edges.number[side][e]);
          by_edges.edges[side].push_back(e);
        }
        const VertexId v = sides[side].origin(h);
        if (vertices.number[side][v] != 0) {
          by_vertices.numbers.push_back(vertices.number[side][v]);
          for (const HalfedgeId out : sides.outgoing[side][v]) {
            by_vertices.edges[side].push_back(edge_of(out));
          }
        }
      }
    }
  }
  return !by_edges.numbers.empty()      ? by_edges
         : !by_vertices.numbers.empty() ? by_vertices
                                        : unknown;
}

Point place_in(const ExactComplex& complex, FaceId f) {
  try {
    return interior_point(complex, f);
  } catch (const Error&) {
    return midpoint(complex, edge_of(complex.cycles[complex.face_outer[f]].front()));
  }
}

std::string message_of(const Group& group) {
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  if (n == 0) return "an exact face is missing from the float result";
  if (m == 0) return "a float face has no exact counterpart";
  if (m == 1 && n == 1) return "a face has other edges on its outer boundary";
  return fmt::format("{} became {}", counted(m, "one exact face", "exact faces"),
                     counted(n, "one float face", "float faces"));
}

/// Where a face that has no counterpart lies.
std::string note(const Places& places, Side side, std::size_t f) {
  const auto place = places[side].find(f);
  if (place == places[side].end()) {
    return " (no interior point could be found in the invalid complex)";
  }
  const FaceId g = place->second.there;
  if (!g.valid()) return fmt::format("; its place is in no {} face", name(other(side)));
  return g == kUnbounded ? fmt::format("; its place is in the unbounded {} face", name(other(side)))
                         : fmt::format("; its place is in {} face {}", name(other(side)),
                                       static_cast<std::size_t>(g));
}

/// A finding about the cells of a group.
Finding finding_about(const Sides& sides, const Group& group, const Cause& cause) {
  Finding finding;
  finding.kind = CellKind::Face;
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  finding.disagreement = n == 0   ? Disagreement::Missing
                         : m == 0 ? Disagreement::Extra
                         : m == n ? Disagreement::Reshaped
                         : m > n  ? Disagreement::Merged
                                  : Disagreement::Split;
  finding.message = message_of(group);
  finding.segments = joined(segments_of(sides[Exact], cause.edges[Exact]),
                            segments_of(sides[Float], cause.edges[Float]));
  for (const Side side : kBothSides) cells(finding, side) = group[side];
  return finding;
}

/// Says where to look, and what is there instead of a face without counterpart.
void add_place(Finding& finding, const Sides& sides, const Group& group, const Places& places) {
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  const Side side = m == 0 || m < n ? Float : Exact;
  const std::size_t last = group[side].back();
  const auto place = places[side].find(last);
  finding.where =
      place != places[side].end() ? place->second.inside : place_in(sides[side], FaceId(last));
  if (m > 0 && n > 0) return;
  finding.message += note(places, side, last);
  if (place != places[side].end() && place->second.there.valid()) {
    finding.lies_in = place->second.there;
  }
}

/// Numbers the groups; where one is one to one, its faces match.
FaceMatch numbered(const Sides& sides, const Groups& groups) {
  FaceMatch result;
  for (const Side side : kBothSides) {
    result.match[side].resize(sides[side].face_count());
    result.group[side].assign(sides[side].face_count(), kNoGroup);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group& group = groups[i];
    for (const Side side : kBothSides) {
      for (const std::size_t f : group[side]) result.group[side][f] = i;
    }
    if (group[Exact].size() != 1 || group[Float].size() != 1) continue;
    result.match[Exact][group[Exact][0]] = FaceId(group[Float][0]);
    result.match[Float][group[Float][0]] = FaceId(group[Exact][0]);
  }
  return result;
}

}  // namespace

FaceMatch match_faces(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
                      const CycleMatch& cycles, bool float_is_valid, Detail detail) {
  Groups groups{{{{kUnbounded}, {kUnbounded}}}};
  append(groups, same_boundaries(sides, cycles, faces_without(sides, groups)));
  const std::size_t same = groups.size();

  const OpenFaces differing = faces_without(sides, groups);
  Groups reshaped;
  append(reshaped, connected_groups(differing, boundary_pairs(sides, cycles, differing)));
  append(groups, reshaped);
  const OpenFaces open = faces_without(sides, groups);
  const std::optional<Overlaps> overlaps =
      overlaps_wanted(sides, differing, open, float_is_valid, detail);

  const bool is_full = detail == Detail::Full;
  const Places places = is_full ? places_of(sides, open, float_is_valid) : Places();
  const Groups rest = connected_groups(open, overlaps ? overlaps->pairs(open) : Pairs());
  append(groups, rest);  // but for the faces that correspond to none

  FaceMatch result = numbered(sides, groups);
  result.same = same;
  const auto report = [&](const Group& group) {
    Cause cause = cause_of(sides, vertices, edges, group);
    Finding finding = finding_about(sides, group, cause);
    if (is_full) {
      finding.area = area_in_dispute(sides, overlaps, group);
      add_place(finding, sides, group, places);
    }
    add_causes(finding, std::move(cause.numbers));
    result.findings.push_back(std::move(finding));
  };
  std::for_each(reshaped.begin(), reshaped.end(), report);
  std::for_each(rest.begin(), rest.end(), report);
  return result;
}

}  // namespace plumbline::compare_steps
