#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "plumbline/chains/triangulate.hpp"
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

/// The boundary of a chain of faces: the halfedges with a face of the chain on their left and none
/// on their right. Ascending. Source: Paoluzzi,
/// "Accelerated intersection of geometric objects", November 2015, as below; section 2.11
/// (chain2BoundaryChain). Throws here and below: Error
/// BadInput for a face that the complex has not.
std::vector<HalfedgeId> boundary_chain(const Incidences& complex, std::span<const FaceId> chain);

/// The same as closed walks, counter-clockwise around the chain, clockwise around its holes; those
/// that touch in a vertex stay apart. By least halfedge, which each starts with. Section 2.12
/// (boundaryCycles).
Lists<HalfedgeId> boundary_cycles(const Incidences& complex, std::span<const FaceId> chain);

/// The same as closed polylines, the first point repeated. Section 2.12 (boundaryPolylines).
std::vector<std::vector<PointD>> boundary_polylines(const FloatComplex& complex,
                                                    std::span<const FaceId> chain);

/// Bridge edges that join the holes of a bounded face to its outer boundary: one per hole, from its
/// least vertex to the nearest lesser one that it sees, so that no bridge crosses an edge or
/// another bridge. **Rounded** predicates. Cost: O(holes x vertices x edges of the face) at worst.
/// Section 2.7 (scan). Throws here and below: Error BadInput for another face, or for a complex so
/// invalid that a hole sees no lesser vertex.
std::vector<std::array<VertexId, 2>> bridge_edges(const FloatComplex& complex, FaceId face);

}  // namespace plumbline
