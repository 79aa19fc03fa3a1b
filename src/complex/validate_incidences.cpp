#include <algorithm>
#include <numeric>
#include <span>

#include "complex/validate.hpp"

namespace plumbline {
namespace {

bool canonical_sizes(const ExactComplex& c) {
  return !c.face_outer.empty() && !c.face_outer[0].valid() &&
         c.edge_sources.size() == c.edge_count() && c.face_holes.size() == c.face_count() &&
         c.face_isolated_vertices.size() == c.face_count() &&
         c.cycle_face.size() == c.cycles.size() && c.halfedge_face.size() == 2 * c.edge_count() &&
         c.vertex_component.size() == c.vertices.size() && c.face_depth.size() == c.face_count();
}

void check_indices(const ExactComplex& c, Violations& violations) {
  if (!canonical_sizes(c)) {
    violations.add({Invariant::Index, "the members of the complex differ in size", {}, {}, {}, {}});
    return;
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const auto [tail, head] = c.edges[e];
    if (tail < head && head < c.vertices.size()) continue;
    violations.add({Invariant::Index,
                    "an edge does not run from a vertex to a later one",
                    tail < c.vertices.size() ? c.vertices[tail] : Point{},
                    {},
                    {EdgeId(e)},
                    {}});
  }
  const auto in_range = [](const auto& ids, std::size_t count) {
    return std::all_of(ids.begin(), ids.end(), [&](auto id) { return id < count; });
  };
  bool good = in_range(c.cycles.flat(), 2 * c.edge_count()) &&
              in_range(c.face_holes.flat(), c.cycles.size()) &&
              in_range(c.face_isolated_vertices.flat(), c.vertices.size()) &&
              in_range(c.vertex_component, c.component_count()) &&
              in_range(c.component_parent, c.face_count());
  for (std::size_t f = 1; f < c.face_count(); ++f) good = good && c.face_outer[f] < c.cycles.size();
  for (std::size_t i = 0; i < c.cycles.size(); ++i) good = good && !c.cycles[i].empty();
  if (!good) violations.add({Invariant::Index, "an index is out of range", {}, {}, {}, {}});
}

void check_cycles(const ExactComplex& c, Violations& violations) {
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    const auto cycle = c.cycles[i];
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const HalfedgeId h = cycle[k], next = cycle[(k + 1) % cycle.size()];
      if (c.target(h) == c.origin(next)) continue;
      violations.add({Invariant::CycleClosed,
                      "a cycle jumps from one vertex to another",
                      c.vertices[c.target(h)],
                      {c.target(h), c.origin(next)},
                      {edge_of(h), edge_of(next)},
                      {c.cycle_face[i]}});
    }
  }
}

/// The neighbours of each vertex.
class Neighbours {
 public:
  explicit Neighbours(const ExactComplex& c)
      : begin_(c.vertices.size() + 2), list_(2 * c.edge_count()) {
    for (const Edge& e : c.edges) {
      ++begin_[e.tail + std::size_t{2}];
      ++begin_[e.head + std::size_t{2}];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (const auto& [tail, head] : c.edges) {
      list_[begin_[tail + std::size_t{1}]++] = head;
      list_[begin_[head + std::size_t{1}]++] = tail;
    }
  }
  std::span<const VertexId> operator[](VertexId v) const {
    return std::span(list_).subspan(begin_[v], begin_[v + std::size_t{1}] - begin_[v]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<VertexId> list_;
};

/// Components are found anew by walking along edges from each vertex in turn.
void check_components(const ExactComplex& c, Violations& violations) {
  const Neighbours neighbours(c);
  std::vector<bool> seen(c.vertices.size(), false);
  std::size_t count = 0;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    std::vector<VertexId> stack{VertexId(first)};
    seen[first] = true;
    while (!stack.empty()) {
      const VertexId v = stack.back();
      stack.pop_back();
      if (c.vertex_component[v] != ComponentId(count)) {
        violations.add({Invariant::Derived,
                        "a vertex names another component than its own",
                        c.vertices[v],
                        {v},
                        {},
                        {}});
      }
      for (const VertexId w : neighbours[v]) {
        if (!seen[w]) stack.push_back(w);
        seen[w] = true;
      }
    }
    ++count;
  }
  if (count == c.component_count()) return;
  violations.add({Invariant::Derived,
                  "there are " + std::to_string(count) + " components, not " +
                      std::to_string(c.component_count()),
                  {},
                  {},
                  {},
                  {}});
}

/// Depths are found anew by going outwards from each face. Faces that lie in each other in a circle
/// have depth 0 (and one of them breaks Nesting).
void check_depths(const ExactComplex& c, Violations& violations) {
  constexpr std::uint32_t kOpen = 0xffffffffU;
  std::vector<std::uint32_t> depth(c.face_count(), kOpen);
  depth[kUnbounded] = 0;
  std::vector<bool> is_in_circle(c.face_count());
  std::vector<FaceId> way;
  for (std::size_t i = 0; i < c.face_count(); ++i) {
    way.clear();
    FaceId f(i);
    for (; depth[f] == kOpen; f = c.parent(f)) {
      depth[f] = 0;  // where the way comes back to it
      is_in_circle[f] = true;
      way.push_back(f);
    }
    for (; !way.empty(); way.pop_back()) {
      const FaceId inner = way.back(), outer = c.parent(inner);
      is_in_circle[inner] = is_in_circle[outer];
      depth[inner] = is_in_circle[inner] ? 0 : depth[outer] + 1;
    }
  }
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    if (c.face_depth[f] == depth[f]) continue;
    violations.add(
        {Invariant::Derived,
         "a face is not one deeper than the face around it",
         f == kUnbounded ? Point{} : c.vertices[c.origin(c.cycles[c.face_outer[f]].front())],
         {},
         {},
         {FaceId(f)}});
  }
}

/// d1 d2 = 0, column by column: the boundary of each face's edges.
void check_boundary_of_boundary(const ExactComplex& c, Violations& violations) {
  std::vector<int> coefficient(c.vertices.size(), 0);
  std::vector<VertexId> touched;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    touched.clear();
    const auto add = [&](CycleId cycle) {
      for (const HalfedgeId h : c.cycles[cycle]) {
        --coefficient[c.origin(h)];
        ++coefficient[c.target(h)];
        touched.push_back(c.origin(h));
        touched.push_back(c.target(h));
      }
    };
    if (c.face_outer[f].valid()) add(c.face_outer[f]);
    for (const CycleId hole : c.face_holes[f]) add(hole);
    std::erase_if(touched, [&](VertexId v) { return coefficient[v] == 0; });
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const VertexId v : touched) {
      violations.add({Invariant::BoundaryOfBoundary,
                      "the boundary of a face has a boundary",
                      c.vertices[v],
                      {v},
                      {},
                      {FaceId(f)}});
      coefficient[v] = 0;
    }
  }
}

void check_euler(const ExactComplex& c, Violations& violations) {
  if (c.vertices.size() + c.face_count() == c.edge_count() + 1 + c.component_count()) return;
  violations.add({Invariant::Euler,
                  "V - E + F = 1 + C does not hold for V " + std::to_string(c.vertices.size()) +
                      ", E " + std::to_string(c.edge_count()) + ", F " +
                      std::to_string(c.face_count()) + ", C " + std::to_string(c.component_count()),
                  {},
                  {},
                  {},
                  {}});
}

}  // namespace

void validate_incidences(const ExactComplex& complex, Violations& violations) {
  check_indices(complex, violations);
  if (violations.has(Invariant::Index)) return;
  validate_claims(complex, violations);
  check_cycles(complex, violations);
  check_components(complex, violations);
  check_depths(complex, violations);
  check_boundary_of_boundary(complex, violations);
  check_euler(complex, violations);
}

}  // namespace plumbline
