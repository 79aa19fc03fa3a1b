// Overlays faces of both sides; labels are 2 f for exact faces and 2 f + 1 for float faces.

#include "compare/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/face_overlaps.hpp"
#include "compare/winding.hpp"

namespace plumbline::compare_steps {

namespace {

std::vector<BoundaryPiece> boundaries(const Sides& sides,
                                      const Both<std::vector<std::size_t>>& faces) {
  std::vector<BoundaryPiece> pieces;
  for (const Side side : kBothSides) {
    for (const std::size_t f : faces[side]) {
      add_boundary(pieces, sides[side], FaceId(f), 2 * f + side);
    }
  }
  return pieces;
}

}  // namespace

bool can_be_overlaid(const Sides& sides, const Both<std::vector<std::size_t>>& faces) {
  constexpr double kSurelyWithinLimit = 0x1p300;
  std::vector<PointD> ends;
  for (const Side side : kBothSides) {
    const auto may_be_added = [&](VertexId v) {
      const PointD& p = sides.points[side].rough(v);
      ends.push_back(p);
      return std::max(std::abs(p.x), std::abs(p.y)) < kSurelyWithinLimit ||
             is_within_limit(sides.point(side, v));
    };
    const auto may_be_cycle = [&](CycleId cycle) {
      const auto halfedges = sides[side].cycles[cycle];
      return std::all_of(halfedges.begin(), halfedges.end(), [&](HalfedgeId h) {
        return may_be_added(sides[side].origin(h)) && may_be_added(sides[side].target(h));
      });
    };
    for (const std::size_t f : faces[side]) {
      const auto holes = sides[side].face_holes[f];
      if (!may_be_cycle(sides[side].face_outer[f]) ||
          !std::all_of(holes.begin(), holes.end(), may_be_cycle)) {
        return false;
      }
    }
  }
  return !are_crowded(ends);
}

std::optional<std::vector<Region>> overlay(const Sides& sides,
                                           const Both<std::vector<std::size_t>>& faces,
                                           bool float_is_valid) {
  if (!can_be_overlaid(sides, faces)) return std::nullopt;
  if (float_is_valid) return face_overlaps(sides, faces);
  const std::optional<Overlaid> overlaid = compare_steps::overlaid(boundaries(sides, faces), {});
  if (!overlaid) return std::nullopt;
  const std::vector<Rational> areas = face_areas(overlaid->complex);
  std::vector<Region> regions;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (overlaid->windings[i].empty() || i == kUnbounded) continue;
    Region region{areas[i], {}};
    for (const auto& [label, times] : overlaid->windings[i]) {
      region.faces[label % 2 == 0 ? Exact : Float].push_back(label / 2);
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

Overlaps::Overlaps(std::vector<Region> regions) : regions_(std::move(regions)) {
  for (const Side side : kBothSides) {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      for (const std::size_t f : regions_[i].faces[side]) region_of_face_[side].emplace_back(f, i);
    }
    std::sort(region_of_face_[side].begin(), region_of_face_[side].end());
  }
}

std::vector<std::size_t> Overlaps::regions_of(const Both<std::vector<std::size_t>>& faces) const {
  std::vector<std::size_t> result;
  for (const Side side : kBothSides) {
    for (const std::size_t f : faces[side]) {
      const auto& list = region_of_face_[side];
      auto entry = std::lower_bound(list.begin(), list.end(), std::pair(f, std::size_t{0}));
      for (; entry != list.end() && entry->first == f; ++entry) result.push_back(entry->second);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> Overlaps::pairs(
    const Both<std::vector<std::size_t>>& faces) const {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const Side side : kBothSides) {
    for (const std::size_t f : faces[side]) {
      Both<std::vector<std::size_t>> alone;
      alone[side] = {f};
      Rational uncovered = 0;  // by the faces asked about
      std::map<std::size_t, Rational> covered_by;
      for (const std::size_t i : regions_of(alone)) {
        bool is_covered = false;
        for (const std::size_t g : regions_[i].faces[other(side)]) {
          if (!std::binary_search(faces[other(side)].begin(), faces[other(side)].end(), g)) {
            continue;
          }
          covered_by[g] += regions_[i].area;
          is_covered = true;
        }
        if (!is_covered) uncovered += regions_[i].area;
      }
      const auto largest =
          std::max_element(covered_by.begin(), covered_by.end(), [](const auto& a, const auto& b) {
            return a.second < b.second;
          });  // the least of several
      if (largest == covered_by.end() || largest->second < uncovered) continue;
      result.push_back(side == Exact ? std::pair(f, largest->first) : std::pair(largest->first, f));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Rational Overlaps::symmetric_difference(const Both<std::vector<std::size_t>>& faces) const {
  Rational area = 0;
  for (const std::size_t i : regions_of(faces)) {
    const auto covers = [&](Side side) {
      const auto& here = regions_[i].faces[side];
      return std::any_of(here.begin(), here.end(), [&](std::size_t f) {
        return std::binary_search(faces[side].begin(), faces[side].end(), f);
      });
    };
    if (covers(Exact) != covers(Float)) area += regions_[i].area;
  }
  return area;
}

}  // namespace plumbline::compare_steps
