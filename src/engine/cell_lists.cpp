// Turns the lists into edges and rings of halfedges; `complete_boundaries` does the rest.

#include "plumbline/engine/cell_lists.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/complete_boundaries.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using Ring = std::vector<VertexId>;

/// Twice the signed area. **Exact**.
Rational twice_area(const std::vector<PointD>& vertices, const Ring& ring) {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = exact(vertices[ring[i]]), q = exact(vertices[ring[(i + 1) % ring.size()]]);
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}

class FromLists {
 public:
  explicit FromLists(const CellLists& cells) : cells_(cells) {
    complex_.vertices = cells.vertices;
    for (const auto& [v, w] : cells.edges) add_edge(v, w);
    complex_.face_outer.emplace_back();
    complex_.face_holes.push_back(std::vector<CycleId>());
  }

  FloatComplex run() && {
    for (const Polygon& face : cells_.faces) add_face(face);
    for (std::size_t f = 0; f < complex_.face_outer.size(); ++f) {
      complex_.face_isolated_vertices.push_back(std::vector<VertexId>());
    }
    return std::move(complex_);
  }

 private:
  /// The edges between two vertices, and how often each of them is a side, by direction.
  struct Sides {
    std::vector<EdgeId> edges;
    std::array<std::size_t, 2> uses{};
  };

  void check(VertexId v) const {
    if (v < cells_.vertices.size()) return;
    throw Error(ErrorCode::BadInput,
                "a cell has a vertex that is not there; there are " +
                    std::to_string(cells_.vertices.size()),
                {}, std::to_string(static_cast<std::size_t>(v)));
  }

  Sides& sides(VertexId v, VertexId w) { return sides_[std::minmax(v, w)]; }

  EdgeId add_edge(VertexId v, VertexId w) {
    check(v);
    check(w);
    const EdgeId e(complex_.edges.size());
    complex_.edges.push_back({std::min(v, w), std::max(v, w)});
    complex_.edge_sources.push_back(std::vector<SegmentId>());
    sides(v, w).edges.push_back(e);
    return e;
  }

  /// The side from v to w; of several edges each is taken in turn. Invalid: there is none.
  HalfedgeId side(VertexId v, VertexId w) {
    Sides& between = sides(v, w);
    if (between.edges.empty()) {
      if (cells_.lists_all_edges) return {};
      add_edge(v, w);
    }
    const bool reversed = w < v;
    const std::size_t use = between.uses[reversed ? 1 : 0]++;
    return halfedge(between.edges[use % between.edges.size()], reversed);
  }

  /// Adds the ring as a cycle that runs counter-clockwise or clockwise. Invalid: it has no sides.
  CycleId add_ring(Ring ring, bool counter_clockwise) {
    for (const VertexId v : ring) check(v);
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 2) return {};
    const int turn = sgn(twice_area(cells_.vertices, ring));
    if (turn != 0 && (turn > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
    std::vector<HalfedgeId> cycle;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const HalfedgeId h = side(ring[i], ring[(i + 1) % ring.size()]);
      if (h.valid()) cycle.push_back(h);
    }
    if (cycle.empty()) return {};
    complex_.cycles.push_back(cycle);
    return CycleId(complex_.cycles.size() - 1);
  }

  void add_face(const Polygon& face) {
    const CycleId outer = add_ring(face.outer, true);
    if (!outer.valid()) return;
    std::vector<CycleId> holes;
    for (const Ring& ring : face.holes) {
      if (const CycleId hole = add_ring(ring, false); hole.valid()) holes.push_back(hole);
    }
    complex_.face_outer.push_back(outer);
    complex_.face_holes.push_back(holes);
  }

  const CellLists& cells_;
  FloatComplex complex_;
  std::map<std::pair<VertexId, VertexId>, Sides> sides_;
};

}  // namespace

FloatComplex complex_from_faces(const CellLists& cells) {
  return canonical(complete_boundaries(canonical(FromLists(cells).run())));
}

}  // namespace plumbline
