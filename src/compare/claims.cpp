// Polygons say nothing of what has the same face on both sides. Cycles are walked past it; straight
// vertices that are left over are walked past, too, and the faces stay what they were.

#include "compare/claims.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "compare/near_vertices.hpp"
#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

using Cycle = std::vector<HalfedgeId>;

class Reduction {
 public:
  Reduction(const ExactComplex& whole, const ExactComplex& other, double tolerance)
      : whole_(whole), next_(2 * whole.edge_count()), cycle_of_(2 * whole.edge_count()) {
    for (std::size_t c = 0; c < whole.cycles.size(); ++c) {
      const auto cycle = whole.cycles[c];
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        next_[cycle[i]] = cycle[(i + 1) % cycle.size()];
        cycle_of_[cycle[i]] = CycleId(c);
      }
    }
    find_kept(other, tolerance);
  }

  Claims run() && {
    number_vertices();
    make_edges();
    make_faces();
    result_.complex = canonical(std::move(result_.complex));
    find_origins();
    result_.vertices_left_out = whole_.vertices.size() - result_.vertex.size();
    return std::move(result_);
  }

 private:
  bool is_kept(HalfedgeId h) const { return !whole_.is_antenna(edge_of(h)); }

  /// The halfedge after this one, antennas passed over.
  HalfedgeId next(HalfedgeId h) const {
    for (h = next_[h]; !is_kept(h); h = next_[twin(h)]) {
    }
    return h;
  }

  /// Vertices with kept edges, but for those that only antennas made.
  void find_kept(const ExactComplex& other, double tolerance) {
    std::vector<std::size_t> degree(whole_.vertices.size());
    std::vector<bool> has_antenna(whole_.vertices.size());
    std::vector<HalfedgeId> leaving(whole_.vertices.size());
    for (std::size_t i = 0; i < 2 * whole_.edge_count(); ++i) {
      const HalfedgeId h(i);
      const VertexId v = whole_.origin(h);
      if (is_kept(h)) {
        ++degree[v];
        leaving[v] = h;
      } else {
        has_antenna[v] = true;
      }
    }
    const FilteredPoints points(whole_.vertices), others(other.vertices);
    const NearVertices near(others);
    is_vertex_.resize(whole_.vertices.size());
    for (std::size_t i = 0; i < is_vertex_.size(); ++i) {
      const VertexId v(i);
      is_vertex_[v] = degree[v] > 0;
      if (degree[v] != 2 || !has_antenna[v]) continue;
      is_vertex_[v] = !is_straight(leaving[v]) || has_near(near, points, other, v, tolerance);
    }
  }

  /// Whether the two kept edges where this one leaves are in line.
  bool is_straight(HalfedgeId h) const {
    const HalfedgeId other = next(twin(h));
    return orientation(whole_.vertices[whole_.target(h)], whole_.vertices[whole_.origin(h)],
                       whole_.vertices[whole_.target(other)]) == 0;
  }

  bool has_near(const NearVertices& near, const FilteredPoints& points, const ExactComplex& other,
                VertexId v, double tolerance) const {
    const Rational bound = rational_from(tolerance);
    return std::ranges::any_of(near.proposals(points.rough(v), tolerance), [&](VertexId w) {
      return squared_distance(whole_.vertices[v], other.vertices[w]) <= bound * bound;
    });
  }

  void number_vertices() {
    numbers_.resize(is_vertex_.size());
    for (std::size_t v = 0; v < is_vertex_.size(); ++v) {
      if (!is_vertex_[v]) continue;
      numbers_[v] = VertexId(result_.vertex.size());
      result_.vertex.emplace_back(v);
      result_.complex.vertices.push_back(whole_.vertices[v]);
    }
  }

  /// Edges from vertex to vertex, in canonical order.
  void make_edges() {
    struct Chain {
      Edge edge;
      Cycle halfedges;
    };
    std::vector<Chain> chains;
    for (std::size_t i = 0; i < 2 * whole_.edge_count(); ++i) {
      const HalfedgeId first(i);
      if (!is_kept(first)) {
        ++result_.edges_left_out;  // twice
        continue;
      }
      if (!is_vertex_[whole_.origin(first)]) continue;
      Chain chain{{}, {first}};
      while (!is_vertex_[whole_.target(chain.halfedges.back())]) {
        chain.halfedges.push_back(next(chain.halfedges.back()));
      }
      chain.edge = {numbers_[whole_.origin(first)],
                    numbers_[whole_.target(chain.halfedges.back())]};
      if (chain.edge.tail < chain.edge.head) chains.push_back(std::move(chain));
    }
    result_.edges_left_out /= 2;
    std::ranges::sort(chains, {}, [](const Chain& chain) {
      return std::tuple(chain.edge.tail, chain.edge.head, chain.halfedges.front());
    });
    image_.resize(2 * whole_.edge_count());
    for (const Chain& chain : chains) {
      const EdgeId e(result_.complex.edge_count());
      result_.complex.edges.push_back(chain.edge);
      std::vector<SegmentId> sources;
      std::vector<EdgeId>& parts = result_.edges.emplace_back();
      for (const HalfedgeId h : chain.halfedges) {
        const auto list = whole_.edge_sources[edge_of(h)];
        sources.insert(sources.end(), list.begin(), list.end());
        parts.push_back(edge_of(h));
      }
      std::ranges::sort(sources);
      sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
      result_.complex.edge_sources.push_back(sources);
      image_[chain.halfedges.front()] = halfedge(e, false);
      image_[twin(chain.halfedges.back())] = halfedge(e, true);
      origin_.push_back(chain.halfedges.front());
      origin_.push_back(twin(chain.halfedges.back()));
    }
  }

  /// Whether a cycle runs counter-clockwise: it turns left wherever it is at its least vertex.
  bool is_outer(const Cycle& cycle) const {
    const auto at = [&](std::size_t i) { return whole_.origin(cycle[i % cycle.size()]); };
    VertexId least = at(0);
    for (std::size_t i = 0; i < cycle.size(); ++i) least = std::min(least, at(i));
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (at(i) != least) continue;
      const VertexId before = at(i + cycle.size() - 1);
      if (orientation(whole_.vertices[before], whole_.vertices[least],
                      whole_.vertices[at(i + 1)]) <= 0) {
        return false;
      }
    }
    return true;
  }

  void make_faces() {
    ExactComplex& complex = result_.complex;
    std::vector<std::vector<CycleId>> holes(whole_.face_count());
    std::vector<CycleId> outer(whole_.face_count());
    std::vector<bool> seen(2 * whole_.edge_count());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] || !is_kept(HalfedgeId(i))) continue;
      Cycle walk, cycle;
      for (HalfedgeId h(i); !seen[h]; h = next(h)) {
        seen[h] = true;
        walk.push_back(h);
        if (image_[h].valid()) cycle.push_back(image_[h]);
      }
      const CycleId id(complex.cycles.size());
      complex.cycles.push_back(cycle);
      const FaceId face = whole_.halfedge_face[HalfedgeId(i)];
      if (face != kUnbounded && is_outer(walk)) {
        ensure(!outer[face].valid(), "a face has one outer boundary");
        outer[face] = id;
      } else {
        holes[face].push_back(id);
      }
    }
    complex.face_outer = outer;
    for (const auto& list : holes) {
      complex.face_holes.push_back(list);
      complex.face_isolated_vertices.push_back(std::vector<VertexId>());
    }
  }

  void find_origins() {
    const ExactComplex& complex = result_.complex;
    result_.face.assign(complex.face_count(), kUnbounded);
    for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
      const HalfedgeId h = origin_[complex.cycles[c].front()];
      result_.cycle.push_back(cycle_of_[h]);
      result_.face[complex.cycle_face[c]] = whole_.halfedge_face[h];
    }
  }

  const ExactComplex& whole_;
  std::vector<HalfedgeId> next_;
  std::vector<CycleId> cycle_of_;
  std::vector<bool> is_vertex_;
  std::vector<VertexId> numbers_;   ///< per vertex of the whole
  std::vector<HalfedgeId> image_;   ///< per halfedge that leaves a vertex
  std::vector<HalfedgeId> origin_;  ///< per halfedge of the result the first one there
  Claims result_;
};

}  // namespace

Finding Claims::of_whole(Finding finding) const {
  std::vector<std::size_t> cells;
  for (const std::size_t cell : finding.exact_cells) {
    switch (finding.kind) {
      case CellKind::Vertex:
        cells.push_back(vertex[cell]);
        break;
      case CellKind::Edge:
        cells.insert(cells.end(), edges[cell].begin(), edges[cell].end());
        break;
      case CellKind::Face:
        cells.push_back(face[cell]);
        break;
      case CellKind::Hole:
        cells.push_back(cycle[cell]);
        break;
      case CellKind::Complex:
        cells.push_back(cell);
    }
  }
  std::ranges::sort(cells);
  finding.exact_cells = std::move(cells);
  return finding;
}

Claims claimed_by_polygons(const ExactComplex& complex, const ExactComplex& other,
                           double tolerance) {
  return Reduction(complex, other, tolerance).run();
}

}  // namespace plumbline::compare_steps
