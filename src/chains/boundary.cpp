#include "plumbline/chains.hpp"

#include "plumbline/structure/model.hpp"

namespace plumbline {
namespace {

using Triplet = Eigen::Triplet<int>;

int as_int(std::size_t i) { return static_cast<int>(i); }

ChainMatrix matrix(std::size_t rows, std::size_t columns, const std::vector<Triplet>& triplets) {
  ChainMatrix m(as_int(rows), as_int(columns));
  m.setFromTriplets(triplets.begin(), triplets.end());
  m.prune([](Eigen::Index, Eigen::Index, int value) { return value != 0; });
  return m;
}

ChainMatrix characteristic(std::size_t rows, std::size_t columns,
                           const std::vector<Triplet>& triplets) {
  ChainMatrix m(as_int(rows), as_int(columns));
  m.setFromTriplets(triplets.begin(), triplets.end(), [](int, int) { return 1; });
  return m;
}

}  // namespace

ChainMatrix boundary_1(const Incidences& complex, std::size_t vertex_count) {
  std::vector<Triplet> triplets;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    triplets.emplace_back(as_int(complex.edges[e].tail), as_int(e), -1);
    triplets.emplace_back(as_int(complex.edges[e].head), as_int(e), 1);
  }
  return matrix(vertex_count, complex.edge_count(), triplets);
}

ChainMatrix boundary_2(const Incidences& complex) {
  std::vector<Triplet> triplets;
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    if (!complex.cycle_face[c].valid()) continue;
    for (const HalfedgeId h : complex.cycles[c]) {
      triplets.emplace_back(as_int(edge_of(h)), as_int(complex.cycle_face[c]),
                            is_reversed(h) ? -1 : 1);
    }
  }
  return matrix(complex.edge_count(), complex.face_count(), triplets);
}

ChainMatrix characteristic_ev(const Incidences& complex, std::size_t vertex_count) {
  std::vector<Triplet> triplets;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    triplets.emplace_back(as_int(e), as_int(complex.edges[e].tail), 1);
    triplets.emplace_back(as_int(e), as_int(complex.edges[e].head), 1);
  }
  return characteristic(complex.edge_count(), vertex_count, triplets);
}

ChainMatrix characteristic_fv(const Incidences& complex, std::size_t vertex_count) {
  std::vector<Triplet> triplets;
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    if (!complex.cycle_face[c].valid()) continue;
    for (const HalfedgeId h : complex.cycles[c]) {
      triplets.emplace_back(as_int(complex.cycle_face[c]), as_int(complex.origin(h)), 1);
    }
  }
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    for (const VertexId v : complex.face_isolated_vertices[f]) {
      triplets.emplace_back(as_int(f), as_int(v), 1);
    }
  }
  return characteristic(complex.face_count(), vertex_count, triplets);
}

ChainMatrix characteristic_fe(const Incidences& complex) {
  std::vector<Triplet> triplets;
  for (std::size_t h = 0; h < complex.halfedge_face.size(); ++h) {
    if (!complex.halfedge_face[h].valid()) continue;
    triplets.emplace_back(as_int(complex.halfedge_face[h]), as_int(edge_of(HalfedgeId(h))), 1);
  }
  return characteristic(complex.face_count(), complex.edge_count(), triplets);
}

ChainMatrix boundary_mod_2(const LarModel& model, std::size_t k) {
  const Cells holders = facet_cells(model, k);
  std::vector<Triplet> triplets;
  for (std::size_t f = 0; f < holders.size(); ++f) {
    for (const std::uint32_t cell : holders[f]) triplets.emplace_back(as_int(f), as_int(cell), 1);
  }
  return characteristic(holders.size(), model.cells[k].size(), triplets);
}

}  // namespace plumbline
