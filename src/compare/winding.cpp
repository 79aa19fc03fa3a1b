// Sums windings over the faces of an arrangement: across an edge they change by what lies on it.

#include "compare/winding.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_d.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline::compare_steps {
namespace {

/// Sorted by label, each label once, without zeros.
Windings summed(Windings windings) {
  std::sort(windings.begin(), windings.end());
  Windings result;
  for (const auto& [label, times] : windings) {
    if (!result.empty() && result.back().first == label) {
      result.back().second += times;
    } else {
      result.emplace_back(label, times);
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

/// The arrangement, edges with the numbers of the pieces on them.
std::optional<ExactComplex> arranged(const std::vector<BoundaryPiece>& pieces) {
  if (!can_be_overlaid(pieces)) return std::nullopt;
  SegmentSet set;
  std::vector<SegmentId> number;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].a == pieces[i].b) continue;
    set.add(Segment{pieces[i].a, pieces[i].b}, SourceId());
    number.emplace_back(i);
  }
  ExactComplex complex = arrange(set);
  Lists<SegmentId> sources;
  std::vector<SegmentId> renumbered;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    renumbered.clear();
    for (const SegmentId s : complex.edge_sources[e]) renumbered.push_back(number[s]);
    sources.push_back(renumbered);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

}  // namespace

void add_boundary(std::vector<BoundaryPiece>& pieces, const ExactComplex& complex, FaceId f,
                  std::size_t label) {
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle]) {
      pieces.push_back({complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)],
                        label, edge_of(h)});
    }
  };
  if (complex.face_outer[f].valid()) add(complex.face_outer[f]);
  for (const CycleId hole : complex.face_holes[f]) add(hole);
}

// Pieces in crowds that no bucket can part take time quadratic in them.
bool are_crowded(std::span<const PointD> ends) {
  constexpr double kTiny = 0x1p-24;  // of the extent
  if (ends.size() <= 2 * kMostTinyPieces) return false;
  const double least = kTiny * box_of(ends).longer_side();
  std::size_t tiny = 0;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    if (box_of(ends.subspan(i, 2)).longer_side() < least) ++tiny;
  }
  return tiny > kMostTinyPieces;
}

bool can_be_overlaid(const std::vector<BoundaryPiece>& pieces) {
  std::vector<PointD> ends;
  for (const BoundaryPiece& piece : pieces) {
    if (piece.a == piece.b) continue;
    if (!is_within_limit(piece.a) || !is_within_limit(piece.b)) return false;
    ends.push_back(nearest(piece.a));
    ends.push_back(nearest(piece.b));
  }
  return !are_crowded(ends);
}

std::optional<Overlaid> overlaid(const std::vector<BoundaryPiece>& pieces, Windings outside) {
  std::optional<ExactComplex> complex = arranged(pieces);
  if (!complex) return std::nullopt;
  Overlaid result{std::move(*complex), {}};
  const ExactComplex& c = result.complex;
  result.windings.resize(c.face_count());
  result.windings[kUnbounded] = summed(std::move(outside));
  std::vector<bool> is_seen(c.face_count());
  is_seen[kUnbounded] = true;
  std::vector<FaceId> queue{kUnbounded};
  const auto cross = [&](FaceId from, HalfedgeId h) {
    const FaceId to = c.halfedge_face[twin(h)];
    if (is_seen[to]) return;
    Windings windings = result.windings[from];
    for (const SegmentId s : c.edge_sources[edge_of(h)]) {
      const BoundaryPiece& piece = pieces[s];
      const bool is_along =
          (piece.b < piece.a) == is_reversed(h);  // then it has `from` on its left
      windings.emplace_back(piece.label, is_along ? -1 : 1);
    }
    result.windings[to] = summed(std::move(windings));
    is_seen[to] = true;
    queue.push_back(to);
  };
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const FaceId f = queue[i];
    if (c.face_outer[f].valid()) {
      for (const HalfedgeId h : c.cycles[c.face_outer[f]]) cross(f, h);
    }
    for (const CycleId hole : c.face_holes[f]) {
      for (const HalfedgeId h : c.cycles[hole]) cross(f, h);
    }
  }
  return result;
}

}  // namespace plumbline::compare_steps
