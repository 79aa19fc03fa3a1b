#pragma once

#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/lar.hpp"

namespace plumbline::checking {

/// Pieces in doubles, each with the input segments that it is part of.
struct LineWork {
  std::vector<lar::SegmentD> segments;  ///< those without length count for nothing
  Lists<SegmentId> sources;             ///< per segment
  std::vector<PointD> points;           ///< isolated points
};

/// Every coordinate of the input rounded to the nearest double.
LineWork rounded(const SegmentSet& input);

/// The arrangement of the pieces, their doubles taken as exact. **Exact**. Its sources are those of
/// the pieces. Cost and errors: as `arrange`.
ExactComplex arrange(const LineWork& work, std::size_t threads);

/// The pieces as a graph over their distinct ends, each piece once; isolated points last.
lar::Graph graph_of(const LineWork& work);

/// The complex of pieces that are not cut any more: their arrangement where they meet in common
/// ends only, else the cells of the graph as it is, which may be invalid (edges cross).
ExactComplex cells_of(const LineWork& work, std::size_t threads);

/// Whether the pieces, equal ones once, meet in common ends only.
bool is_plane(const LineWork& work, std::size_t threads);

}  // namespace plumbline::checking
