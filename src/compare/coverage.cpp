// Do the faces of an invalid float complex fill the plane? Each place must lie in one face, once.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "compare/steps.hpp"
#include "compare/winding.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::compare_steps {
namespace {

/// Neighbouring faces of the overlay with the same windings.
struct OverlayPlace {
  std::vector<FaceId> parts;
  Rational area;
};

std::vector<OverlayPlace> places(const Overlaid& overlaid) {
  const ExactComplex& c = overlaid.complex;
  UnionFind sets(c.face_count());
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const FaceId f = c.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId g = c.halfedge_face[halfedge(EdgeId(e), true)];
    if (overlaid.windings[f] == overlaid.windings[g]) sets.unite(f, g);
  }
  const std::vector<Rational> areas = face_areas(c);
  std::map<std::size_t, OverlayPlace> by_least;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (sets.find(f) == kUnbounded) continue;
    OverlayPlace& place = by_least[sets.find(f)];
    place.parts.emplace_back(f);
    place.area += areas[f];
  }
  std::vector<OverlayPlace> result;
  for (auto& entry : by_least) result.push_back(std::move(entry.second));
  return result;
}

/// Whether the place is no wider than the tolerance.
bool is_sliver(const Overlaid& overlaid, const OverlayPlace& place, double tolerance) {
  double perimeter = 0;
  for (const FaceId part : place.parts) {
    for (const HalfedgeId h : overlaid.complex.cycles[overlaid.complex.face_outer[part]]) {
      perimeter += length(squared_distance(overlaid.complex.vertices[overlaid.complex.origin(h)],
                                           overlaid.complex.vertices[overlaid.complex.target(h)]));
    }
  }
  return nearest_double(place.area) <= tolerance * perimeter / 2;
}

/// The unbounded face is what bounded faces leave, so it overlaps with none of them. It is where
/// none of them is and its boundary has not been crossed.
void let_bounded_prevail(Windings& windings) {
  const auto is_unbounded = [](const auto& entry) { return entry.first == kUnbounded; };
  const bool is_outside =
      windings.size() == 1 && is_unbounded(windings[0]) && windings[0].second > 0;
  if (!is_outside) std::erase_if(windings, is_unbounded);
}

/// What is wrong with the windings; empty for one face that winds once (the wrong way round is a
/// matter of orientation).
std::string fault(const Windings& windings, const std::string& area) {
  if (windings.empty()) return fmt::format("no face covers a gap of area {}", area);
  if (windings.size() == 1) {
    const auto [label, times] = windings.front();
    if (label == kUnbounded || std::abs(times) == 1) return {};
    return fmt::format("float face {} covers an area of {} {} times", label, area, std::abs(times));
  }
  std::string names;
  for (std::size_t i = 0; i < windings.size(); ++i) {
    names += fmt::format("{}float face {}",
                         i == 0                     ? ""
                         : i + 1 == windings.size() ? " and "
                                                    : ", ",
                         windings[i].first);
  }
  return fmt::format("{} overlap in an area of {}", names, area);
}

}  // namespace

std::vector<Finding> miscoverings(const Sides& sides, const std::vector<Finding>& invalidities) {
  const auto moves_faces = [](const Finding& f) {
    constexpr std::array kMoveFaces = {Invariant::HalfedgeInCycle, Invariant::CycleClosed,
                                       Invariant::Crossing,        Invariant::VertexOnEdge,
                                       Invariant::DuplicateVertex, Invariant::DuplicateEdge,
                                       Invariant::CyclicOrder};
    return std::find(kMoveFaces.begin(), kMoveFaces.end(), f.invariant) != kMoveFaces.end();
  };
  if (std::none_of(invalidities.begin(), invalidities.end(), moves_faces)) return {};
  std::vector<BoundaryPiece> pieces;
  for (std::size_t f = 0; f < sides[Float].face_count(); ++f) {
    add_boundary(pieces, sides[Float], FaceId(f), f);
  }
  std::optional<Overlaid> overlaid = compare_steps::overlaid(pieces, {{kUnbounded, 1}});
  if (!overlaid) return {};
  for (Windings& windings : overlaid->windings) let_bounded_prevail(windings);
  Numbers number(sides[Float].edge_count());
  for (std::size_t i = 0; i < invalidities.size(); ++i) {
    if (invalidities[i].kind == CellKind::Edge && moves_faces(invalidities[i])) {
      for (const std::size_t e : invalidities[i].float_cells) {
        if (number[e] == 0) number[e] = i + 1;
      }
    }
  }

  std::vector<Finding> findings;
  for (const OverlayPlace& place : places(*overlaid)) {
    const Windings& windings = overlaid->windings[place.parts.front()];
    const std::string message = fault(windings, rough(nearest_double(place.area)));
    if (message.empty() || is_sliver(*overlaid, place, sides.tolerance)) continue;
    if (findings.size() == kMaxViolations) break;
    Finding finding;
    finding.kind = CellKind::Face;
    finding.invariant = Invariant::Area;
    finding.where = interior_point(overlaid->complex, place.parts.front());
    finding.area = place.area;
    for (const auto& entry : windings) finding.float_cells.push_back(entry.first);
    Numbers causes;
    std::vector<EdgeId> edges;
    for (const FaceId part : place.parts) {
      for (const HalfedgeId h : overlaid->complex.cycles[overlaid->complex.face_outer[part]]) {
        for (const SegmentId s : overlaid->complex.edge_sources[edge_of(h)]) {
          edges.push_back(pieces[s].edge);
          causes.push_back(number[pieces[s].edge]);
        }
      }
    }
    finding.segments = segments_of(sides[Float], edges);
    finding.message = fmt::format("the float result is not a valid complex: {} ({})", message,
                                  to_text(Invariant::Area));
    add_causes(finding, std::move(causes));
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace plumbline::compare_steps
