#include <algorithm>

#include "complex/direction.hpp"
#include "complex/validate.hpp"

namespace plumbline {
namespace {

void check_orientation(const ExactComplex& c, const std::vector<Rational>& areas,
                       Violations& violations) {
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    if (c.face_outer[f].valid() && areas[c.face_outer[f]] <= 0) {
      violations.add({Invariant::Orientation,
                      "an outer boundary does not run counter-clockwise",
                      c.vertices[c.origin(c.cycles[c.face_outer[f]].front())],
                      {},
                      {},
                      {FaceId(f)}});
    }
    for (const CycleId hole : c.face_holes[f]) {
      if (areas[hole] <= 0) continue;
      violations.add({Invariant::Orientation,
                      "a hole does not run clockwise",
                      c.vertices[c.origin(c.cycles[hole].front())],
                      {},
                      {},
                      {FaceId(f)}});
    }
  }
}

/// The halfedge after h in its cycle must be the first one clockwise from h's twin around h's
/// target.
void check_cyclic_order(const ExactComplex& c, Violations& violations) {
  std::vector<HalfedgeId> next(2 * c.edge_count());
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    const auto cycle = c.cycles[i];
    for (std::size_t k = 0; k < cycle.size(); ++k) next[cycle[k]] = cycle[(k + 1) % cycle.size()];
  }
  std::vector<std::vector<HalfedgeId>> leaving(c.vertices.size());
  for (std::size_t h = 0; h < next.size(); ++h) {
    leaving[c.origin(HalfedgeId(h))].emplace_back(h);
  }
  for (std::size_t v = 0; v < leaving.size(); ++v) {
    std::vector<std::pair<Direction, HalfedgeId>> around;
    for (const HalfedgeId h : leaving[v]) {
      around.emplace_back(Direction(c.vertices[v], c.vertices[c.target(h)]), h);
    }
    std::sort(around.begin(), around.end());
    for (std::size_t k = 0; k < around.size(); ++k) {
      const HalfedgeId clockwise = around[(k + around.size() - 1) % around.size()].second;
      const HalfedgeId arriving = twin(around[k].second);
      if (next[arriving] == clockwise) continue;
      violations.add({Invariant::CyclicOrder,
                      "a cycle does not turn to the next edge clockwise",
                      c.vertices[v],
                      {VertexId(v)},
                      {edge_of(arriving), edge_of(clockwise)},
                      {}});
    }
  }
}

/// The outer boundaries in a component enclose together what its hole in the parent face leaves
/// out.
void check_areas(const ExactComplex& c, const std::vector<Rational>& areas,
                 Violations& violations) {
  std::vector<Rational> sum(c.component_count());
  std::vector<VertexId> somewhere(c.component_count());
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    const VertexId v = c.origin(c.cycles[i].front());
    const ComponentId component = c.vertex_component[v];
    if (!somewhere[component].valid()) somewhere[component] = v;
    sum[component] += areas[i];
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (sum[k] == 0) continue;
    violations.add({Invariant::Area,
                    "the faces of a component do not add up to the area it encloses",
                    c.vertices[somewhere[k]],
                    {somewhere[k]},
                    {},
                    {}});
  }
}

}  // namespace

void validate_faces(const ExactComplex& complex, Violations& violations) {
  const std::vector<Rational> areas = cycle_areas(complex);
  check_orientation(complex, areas, violations);
  check_cyclic_order(complex, violations);
  check_areas(complex, areas, violations);
}

}  // namespace plumbline
