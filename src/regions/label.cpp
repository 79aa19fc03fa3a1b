// Winding numbers from the unbounded face inwards, over edges.

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

/// Per segment the regions that it belongs to, once for each time.
Lists<RegionId> regions_of_segments(const std::vector<Region>& regions, std::size_t segments) {
  std::vector<std::pair<SegmentId, RegionId>> pairs;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const SegmentId s : regions[r].segments) {
      ensure(s < segments, "a region has segments of the drawing");
      pairs.emplace_back(s, RegionId(r));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Lists<RegionId> result;
  std::vector<RegionId> of;
  std::size_t i = 0;
  for (std::size_t s = 0; s < segments; ++s) {
    of.clear();
    for (; i < pairs.size() && pairs[i].first == s; ++i) of.push_back(pairs[i].second);
    result.push_back(of);
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

/// Throws where a region begins and ends in other points.
void ensure_closed(const ExactComplex& complex, const std::vector<Region>& regions,
                   const Lists<WindingChange>& of_edges) {
  std::vector<std::tuple<RegionId, VertexId, std::int32_t>> ends;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const auto& [region, by] : of_edges[e]) {
      ends.emplace_back(region, complex.edges[e].head, by);
      ends.emplace_back(region, complex.edges[e].tail, -by);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size();) {
    const auto [region, vertex, first] = ends[i];
    std::int64_t sum = first;
    for (++i; i < ends.size() && std::get<0>(ends[i]) == region && std::get<1>(ends[i]) == vertex;
         ++i) {
      sum += std::get<2>(ends[i]);
    }
    const bool is_closed = regions[region].rule == FillRule::EvenOdd ? sum % 2 == 0 : sum == 0;
    if (is_closed) continue;
    throw Error(ErrorCode::BadInput,
                "a region is not closed at (" + to_text(complex.vertices[vertex]) + ")", {},
                regions[region].name);
  }
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
