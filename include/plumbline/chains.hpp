#pragma once

#include <Eigen/SparseCore>

#include "plumbline/complex.hpp"

namespace plumbline {

struct LarModel;

/// A sparse matrix with small integer entries; rows are the lower-dimensional cells.
using ChainMatrix = Eigen::SparseMatrix<int>;

/// The boundary operator d1, vertices x edges: -1 at an edge's tail, +1 at its head.
ChainMatrix boundary_1(const Incidences& complex, std::size_t vertex_count);
/// The boundary operator d2, edges x faces (the unbounded face is column 0): the number of times
/// that the face's cycles run along the edge minus against it. The entries of an antenna cancel to
/// no entry.
ChainMatrix boundary_2(const Incidences& complex);

/// Characteristic matrices of LAR, unsigned, entries 0 and 1. Rows: edges (EV), faces (FV, FE).
/// Antennas and isolated vertices count as incident to their face.
ChainMatrix characteristic_ev(const Incidences& complex, std::size_t vertex_count);
ChainMatrix characteristic_fv(const Incidences& complex, std::size_t vertex_count);
ChainMatrix characteristic_fe(const Incidences& complex);

/// The boundary operator of a LAR model mod 2, facets (cells[k + 1]) x cells (cells[k]): 1 where
/// the cell holds the facet, by the rule of `facet_cells`. Requires: k + 1 < model.cells.size().
ChainMatrix boundary_mod_2(const LarModel& model, std::size_t k = 0);

}  // namespace plumbline
