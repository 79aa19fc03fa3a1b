// Walks along the boundary of a face past its antennas and parts the walk where it comes to a
// vertex again.

#include "plumbline/polygons.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using VertexRing = std::vector<VertexId>;

/// Per halfedge the next one of its cycle.
std::vector<HalfedgeId> nexts(const Incidences& complex) {
  std::vector<HalfedgeId> result(2 * complex.edge_count());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    const auto cycle = complex.cycles[c];
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      result[cycle[i]] = cycle[i + 1 == cycle.size() ? 0 : i + 1];
    }
  }
  return result;
}

/// The simple rings of a closed walk: where it comes to a vertex again, what lies between is one.
void part(std::vector<VertexId> walk, std::vector<VertexRing>& rings) {
  std::vector<VertexId> met = walk;
  std::sort(met.begin(), met.end());
  if (!walk.empty() && std::adjacent_find(met.begin(), met.end()) == met.end()) {
    rings.push_back(std::move(walk));
    return;
  }
  std::vector<VertexId> open;
  std::unordered_map<std::size_t, std::size_t> place;  // in `open`, by vertex
  for (const VertexId v : walk) {
    const auto [found, is_new] = place.try_emplace(v, open.size());
    if (!is_new) {
      const auto first = open.begin() + static_cast<std::ptrdiff_t>(found->second);
      rings.emplace_back(first, open.end());
      for (auto it = first + 1; it != open.end(); ++it) place.erase(*it);
      open.erase(first + 1, open.end());
    } else {
      open.push_back(v);
    }
  }
  if (!open.empty()) rings.push_back(std::move(open));
}

void begin_at_least(VertexRing& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

/// Vertices are in lexicographical order: a ring turns in its least one as it turns on the whole.
bool is_counter_clockwise(const ExactComplex& complex, const VertexRing& ring) {
  return orientation(complex.vertices[ring.back()], complex.vertices[ring.front()],
                     complex.vertices[ring[1]]) > 0;
}

class Boundaries {
 public:
  explicit Boundaries(const ExactComplex& complex)
      : complex_(complex), next_(nexts(complex)), is_done_(next_.size()) {}

  FacePolygon polygon(FaceId face) {
    FacePolygon result;
    result.face = face;
    std::vector<VertexRing> rings;
    add(complex_.face_outer[face], result, rings);
    for (const CycleId hole : complex_.face_holes[face]) add(hole, result, rings);
    std::sort(result.antennas.begin(), result.antennas.end());
    for (VertexRing& ring : rings) begin_at_least(ring);
    std::sort(rings.begin(), rings.end());
    for (VertexRing& ring : rings) {
      ensure(ring.size() > 2, "a ring of a valid complex has three vertices");
      if (rings.size() == 1 || is_counter_clockwise(complex_, ring)) {
        ensure(result.outer.empty(), "a face of a valid complex has one outer boundary");
        result.outer = std::move(ring);
      } else {
        result.holes.push_back(ring);
      }
    }
    ensure(!result.outer.empty(), "a face of a valid complex has an outer boundary");
    return result;
  }

 private:
  /// The rings of a cycle, and its antennas.
  void add(CycleId cycle, FacePolygon& polygon, std::vector<VertexRing>& rings) {
    for (const HalfedgeId first : complex_.cycles[cycle]) {
      if (complex_.is_antenna(edge_of(first))) {
        if (!is_reversed(first)) polygon.antennas.push_back(edge_of(first));
        continue;
      }
      VertexRing walk;
      for (HalfedgeId h = first; !is_done_[h]; h = next_past_antennas(h)) {
        is_done_[h] = true;
        walk.push_back(complex_.origin(h));
      }
      part(std::move(walk), rings);
    }
  }

  /// Antennas that begin where h ends are passed by, around that vertex.
  HalfedgeId next_past_antennas(HalfedgeId h) const {
    HalfedgeId next = next_[h];
    while (complex_.is_antenna(edge_of(next))) next = next_[twin(next)];
    return next;
  }

  const ExactComplex& complex_;
  std::vector<HalfedgeId> next_;
  std::vector<bool> is_done_;
};

}  // namespace

std::vector<FacePolygon> polygons(const ExactComplex& complex) {
  Boundaries boundaries(complex);
  std::vector<FacePolygon> result;
  if (complex.face_count() > 1) result.reserve(complex.face_count() - 1);
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    result.push_back(boundaries.polygon(FaceId(f)));
  }
  return result;
}

}  // namespace plumbline
