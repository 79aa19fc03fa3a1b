// Leaves out vertices in the middle of straight sides. Edges run from their lesser ends, and so do
// those that lie on one line, one after the other.

#include <algorithm>
#include <utility>

#include "coverage/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline::coverage_steps {
namespace {

class Straightening {
 public:
  Straightening(const Coverage& coverage, const SegmentSet& input)
      : coverage_(coverage),
        complex_(coverage.complex),
        corners_(input, coverage.polygons),
        next_(complex_.vertices.size()),
        is_gone_(complex_.vertices.size()) {
    std::vector<EdgeId> before(complex_.vertices.size());
    std::vector<std::size_t> degree(complex_.vertices.size());
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const auto [tail, head] = complex_.edges[e];
      ++degree[tail];
      ++degree[head];
      next_[tail] = before[head] = EdgeId(e);
    }
    for (std::size_t v = 0; v < degree.size(); ++v) {
      // One edge comes from the lesser side and one goes on, or it is no straight line.
      if (degree[v] != 2 || !before[v].valid() || !next_[v].valid()) continue;
      is_gone_[v] = is_superfluous(VertexId(v), before[v], next_[v]);
    }
  }

  Coverage run() const {
    Coverage result{coverage_.polygons, {}, {}};
    ExactComplex& made = result.complex;
    std::vector<VertexId> number(is_gone_.size());
    for (std::size_t v = 0; v < is_gone_.size(); ++v) {
      if (is_gone_[v]) continue;
      number[v] = VertexId(made.vertices.size());
      made.vertices.push_back(complex_.vertices, v);
    }
    const std::vector<HalfedgeId> halfedges = add_edges(made, number);
    std::vector<HalfedgeId> cycle;
    for (std::size_t c = 0; c < complex_.cycles.size(); ++c) {
      cycle.clear();
      for (const HalfedgeId h : complex_.cycles[c]) {
        if (halfedges[h].valid()) cycle.push_back(halfedges[h]);
      }
      made.cycles.push_back(cycle);
    }
    made.face_outer = complex_.face_outer;
    made.face_holes = complex_.face_holes;
    made.face_isolated_vertices = complex_.face_isolated_vertices;
    const std::vector<Edge> edges = made.edges;
    made = canonical(std::move(made));
    add_owners(result, edges, halfedges);
    return result;
  }

 private:
  bool is_superfluous(VertexId v, EdgeId before, EdgeId after) const {
    const Point p = complex_.vertices[v];
    if (orientation(complex_.vertices[complex_.edges[before].tail], p,
                    complex_.vertices[complex_.edges[after].head]) != 0) {
      return false;
    }
    const auto is_beside = [&](RegionId polygon) {
      for (const bool reversed : {false, true}) {
        const auto owners = coverage_.owners[complex_.halfedge_face[halfedge(before, reversed)]];
        if (std::binary_search(owners.begin(), owners.end(), polygon)) return true;
      }
      return false;
    };
    for (const EdgeId e : {before, after}) {
      for (const SegmentId s : complex_.edge_sources[e]) {
        const RegionId polygon = corners_.polygon_of(s);
        if (polygon.valid() && is_beside(polygon) && corners_.ends_at(s, p)) return false;
      }
    }
    return true;
  }

  /// One for each line of edges. Per halfedge that begins one, forth or back, that of the new edge.
  std::vector<HalfedgeId> add_edges(ExactComplex& made, const std::vector<VertexId>& number) const {
    std::vector<HalfedgeId> result(2 * complex_.edge_count());
    std::vector<SegmentId> sources;
    for (std::size_t first = 0; first < complex_.edge_count(); ++first) {
      if (is_gone_[complex_.edges[first].tail]) continue;
      EdgeId last(first);
      sources.assign(complex_.edge_sources[first].begin(), complex_.edge_sources[first].end());
      while (is_gone_[complex_.edges[last].head]) {
        last = next_[complex_.edges[last].head];
        const auto more = complex_.edge_sources[last];
        sources.insert(sources.end(), more.begin(), more.end());
      }
      std::sort(sources.begin(), sources.end());
      sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
      const EdgeId e(made.edges.size());
      made.edges.push_back({number[complex_.edges[first].tail], number[complex_.edges[last].head]});
      made.edge_sources.push_back(sources);
      result[halfedge(EdgeId(first), false)] = halfedge(e, false);
      result[halfedge(last, true)] = halfedge(e, true);
    }
    return result;
  }

  /// Vertices kept their order, so edges are found by their ends.
  void add_owners(Coverage& result, const std::vector<Edge>& edges,
                  const std::vector<HalfedgeId>& halfedges) const {
    const auto is_less = [](const Edge& a, const Edge& b) {
      return std::pair(a.tail, a.head) < std::pair(b.tail, b.head);
    };
    std::vector<FaceId> origin(complex_.face_count());
    for (std::size_t h = 0; h < halfedges.size(); ++h) {
      if (!halfedges[h].valid()) continue;
      const auto& now = result.complex.edges;
      const auto e =
          std::lower_bound(now.begin(), now.end(), edges[edge_of(halfedges[h])], is_less);
      const HalfedgeId made =
          halfedge(EdgeId(static_cast<std::size_t>(e - now.begin())), is_reversed(halfedges[h]));
      origin[result.complex.halfedge_face[made]] = complex_.halfedge_face[h];
    }
    origin[kUnbounded] = kUnbounded;
    for (const FaceId f : origin) result.owners.push_back(coverage_.owners[f]);
  }

  const Coverage& coverage_;
  const ExactComplex& complex_;
  const Corners corners_;
  std::vector<EdgeId> next_;  ///< per vertex an edge that goes on from it
  std::vector<bool> is_gone_;
};

}  // namespace

Coverage straightened(const Coverage& coverage, const SegmentSet& input) {
  return Straightening(coverage, input).run();
}

}  // namespace plumbline::coverage_steps
