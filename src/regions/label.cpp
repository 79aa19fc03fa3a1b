// Winding numbers from the unbounded face inwards, over edges.

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

/// Per segment the regions that it belongs to, once for each time.
Lists<RegionId> regions_of_segments(const std::vector<Region>& regions, std::size_t segments) {
  std::vector<std::size_t> end(segments + 1);
  for (const Region& region : regions) {
    for (const SegmentId s : region.segments) {
      ensure(s < segments, "a region has segments of the drawing");
      ++end[s + std::size_t{1}];
    }
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<RegionId> of(end.back());
  std::vector<std::size_t> next(end.begin(), end.end() - 1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const SegmentId s : regions[r].segments) of[next[s]++] = RegionId(r);
  }
  Lists<RegionId> result;
  result.reserve(segments, of.size());
  for (std::size_t s = 0; s < segments; ++s) {
    result.push_back(std::span(of).subspan(end[s], end[s + 1] - end[s]));
  }
  return result;
}

/// Whether segments run from their lexicographically lesser ends, as edges do.
std::vector<bool> are_forward(const SegmentList& segments) {
  std::vector<bool> result(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto n = segments.numbers(s);
    result[s] = n[0] != n[2] ? n[0] < n[2] : n[1] < n[3];
  }
  return result;
}

/// Adds up what is said of one region.
void simplify(std::vector<WindingChange>& changes) {
  std::sort(changes.begin(), changes.end(),
            [](const auto& a, const auto& b) { return a.region < b.region; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < changes.size();) {
    WindingChange sum = changes[i];
    for (++i; i < changes.size() && changes[i].region == sum.region; ++i) sum.by += changes[i].by;
    if (sum.by != 0) changes[kept++] = sum;
  }
  changes.resize(kept);
}

Lists<WindingChange> changes_of_edges(const SegmentSet& input, const ExactComplex& complex,
                                      const std::vector<Region>& regions) {
  const Lists<RegionId> of = regions_of_segments(regions, input.segments.size());
  const std::vector<bool> is_forward = are_forward(input.segments);
  Lists<WindingChange> result;
  std::vector<WindingChange> changes;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    changes.clear();
    for (const SegmentId s : complex.edge_sources[e]) {
      for (const RegionId r : of[s]) changes.push_back({r, is_forward[s] ? 1 : -1});
    }
    simplify(changes);
    result.push_back(changes);
  }
  return result;
}

/// By how much winding numbers change around each vertex, edge by edge.
Lists<WindingChange> changes_of_vertices(const ExactComplex& complex,
                                         const Lists<WindingChange>& of_edges) {
  std::vector<std::size_t> end(complex.vertices.size() + 1);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      end[v + std::size_t{1}] += of_edges[e].size();
    }
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<WindingChange> changes(end.back());
  std::vector<std::size_t> next(end.begin(), end.end() - 1);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const auto& [region, by] : of_edges[e]) {
      changes[next[complex.edges[e].head]++] = {region, by};
      changes[next[complex.edges[e].tail]++] = {region, -by};
    }
  }
  Lists<WindingChange> result;
  result.reserve(complex.vertices.size(), changes.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    result.push_back(std::span(changes).subspan(end[v], end[v + 1] - end[v]));
  }
  return result;
}

/// Throws where a region begins and ends in other points: of the first region, at the first.
void ensure_closed(const ExactComplex& complex, const std::vector<Region>& regions,
                   const Lists<WindingChange>& of_edges) {
  const Lists<WindingChange> of_vertices = changes_of_vertices(complex, of_edges);
  std::pair<RegionId, VertexId> open;
  std::vector<WindingChange> changes;
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    changes.assign(of_vertices[v].begin(), of_vertices[v].end());
    simplify(changes);
    for (const auto& [region, by] : changes) {
      if (regions[region].rule == FillRule::EvenOdd && by % 2 == 0) continue;
      if (!open.first.valid() || region < open.first) open = {region, VertexId(v)};
    }
  }
  if (!open.first.valid()) return;
  throw Error(ErrorCode::BadInput,
              "a region is not closed at (" + to_text(complex.vertices[open.second]) + ")", {},
              regions[open.first].name);
}

/// Makes `order`, `from` and `changes`: neighbours of faces, breadth first.
class Spanning {
 public:
  Spanning(const ExactComplex& complex, LabelledComplex& labelled)
      : complex_(complex), labelled_(labelled) {}

  void run() {
    const std::vector<std::uint32_t> begin = first_halfedges();
    via_.assign(complex_.face_count(), HalfedgeId());
    labelled_.from.assign(complex_.face_count(), FaceId());
    labelled_.order = {kUnbounded};
    for (std::size_t i = 0; i < labelled_.order.size(); ++i) {
      const FaceId face = labelled_.order[i];
      for (std::size_t k = begin[face]; k < begin[face + std::size_t{1}]; ++k) {
        visit(face, halfedges_[k]);
      }
    }
    ensure(labelled_.order.size() == complex_.face_count(), "every face has neighbours");
    for (std::size_t f = 0; f < complex_.face_count(); ++f) add_changes(FaceId(f));
  }

 private:
  /// Halfedges by face; where those of each face begin.
  std::vector<std::uint32_t> first_halfedges() {
    std::vector<std::uint32_t> begin(complex_.face_count() + 1);
    for (const FaceId f : complex_.halfedge_face) ++begin[f + std::size_t{1}];
    for (std::size_t f = 1; f < begin.size(); ++f) begin[f] += begin[f - 1];
    halfedges_.resize(complex_.halfedge_face.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t h = 0; h < halfedges_.size(); ++h) {
      halfedges_[next[complex_.halfedge_face[h]]++] = HalfedgeId(h);
    }
    return begin;
  }

  void visit(FaceId face, HalfedgeId h) {
    const FaceId other = complex_.halfedge_face[twin(h)];
    if (other == kUnbounded || labelled_.from[other].valid()) return;
    labelled_.from[other] = face;
    via_[other] = twin(h);
    labelled_.order.push_back(other);
  }

  /// A halfedge with the face on its left leads there.
  void add_changes(FaceId face) {
    std::vector<WindingChange> changes;
    if (const HalfedgeId h = via_[face]; h.valid()) {
      const auto of_edge = labelled_.edge_changes[edge_of(h)];
      changes.assign(of_edge.begin(), of_edge.end());
      if (is_reversed(h)) {
        for (WindingChange& change : changes) change.by = -change.by;
      }
    }
    labelled_.changes.push_back(changes);
  }

  const ExactComplex& complex_;
  LabelledComplex& labelled_;
  std::vector<HalfedgeId> halfedges_;
  std::vector<HalfedgeId> via_;  ///< per face, on its own side
};

}  // namespace

LabelledComplex label(const SegmentSet& input, const ExactComplex& complex,
                      std::vector<Region> regions) {
  LabelledComplex result;
  result.edge_changes = changes_of_edges(input, complex, regions);
  ensure_closed(complex, regions, result.edge_changes);
  result.regions = std::move(regions);
  Spanning(complex, result).run();
  return result;
}

}  // namespace plumbline
