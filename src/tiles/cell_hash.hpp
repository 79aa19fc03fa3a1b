#pragma once

#include <string_view>

#include "plumbline/tiles.hpp"

/// Hashes of cells, by what names them.
namespace plumbline::tiles {

/// By coordinates modulo two primes, which are the same for all fractions that are equal.
CellHash vertex_hash(const PointList& points, std::size_t v);
/// From end to end: the first one is the edge's tail.
CellHash edge_hash(const CellHash& tail, const CellHash& head);
CellHash halfedge_hash(const CellHash& origin, const CellHash& target);
CellHash corner_hash(const CellHash& before, const CellHash& vertex, const CellHash& behind);
/// Of the sum of its halfedges.
CellHash cycle_hash(const CellHash& halfedges);
CellHash isolated_hash(const CellHash& vertex);
/// Of the sum of its cycles and isolated vertices.
CellHash face_hash(const CellHash& cycles, bool is_bounded);

/// Of any bytes.
CellHash bytes_hash(std::string_view bytes);

}  // namespace plumbline::tiles
