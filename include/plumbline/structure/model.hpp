#pragma once

#include <array>
#include <optional>
#include <utility>

#include "plumbline/detail/lists.hpp"
#include "plumbline/detail/ring.hpp"
#include "plumbline/structure/affine.hpp"
#include "plumbline/structure/curve.hpp"

namespace plumbline {

/// Segments of one drawing element, in the coordinates of the Struct that holds it; or of a table
/// of rows, each an element of its own.
struct Model {
  /// An element of a table: where it begins, how many of the segments it has, its id.
  struct Row {
    std::uint32_t line = 0, column = 0;
    std::uint32_t segment_count = 1;
    std::uint32_t id = 0;  ///< 0: the source's; else index into row_ids plus 1

    friend bool operator==(const Row&, const Row&) = default;
  };

  /// A text at a place, or a name of the element (Label); of a table in this row.
  struct Text {
    std::string text;
    std::optional<NumberPoint> place;
    std::uint32_t row = 0;
    double height = 0;  ///< of its letters, **rounded**; 0: not known

    friend bool operator==(const Text&, const Text&) = default;
  };

  Source source;  ///< its `path` is filled in by `evaluate`, and `layer` where there is none
  SegmentList segments;
  /// Empty, or in the order of the segments what replaces the source's line, column and id.
  std::vector<Row> rows = {};
  std::vector<std::string> row_ids = {};
  std::vector<Curve> curves = {};  ///< which segments are chords; only where there are no rows
  std::vector<Ring> rings = {};    ///< which segments are rings, ascending
  std::vector<Text> labels = {};   ///< in the order of rows

  friend bool operator==(const Model&, const Model&) = default;
};

/// An array of cells, each given by the indices of its vertices.
using Cells = Lists<std::uint32_t>;

/// A LAR model: vertices in a space of any dimension and arrays of cells over them, those of the
/// highest dimension first: (V, CV), (V, FV, EV), (V, CV, FV, EV), ... Source: larstruct 2015, 2.2.
struct LarModel {
  Source source;  ///< its `path` is filled in by `evaluate`
  std::size_t dimension = 2;
  std::vector<Number> coordinates;  ///< `dimension` per vertex
  std::vector<Cells> cells;

  std::size_t vertex_count() const { return coordinates.size() / dimension; }
  /// Requires: v < vertex_count().
  std::span<const Number> vertex(std::size_t v) const {
    return {coordinates.data() + v * dimension, dimension};
  }

  friend bool operator==(const LarModel&, const LarModel&) = default;
};

/// Throws: Error BadInput, with the model's place in `files`, for a dimension of 0, coordinates
/// that are no whole number of vertices, and a cell with a vertex that does not exist.
void check(const LarModel& model, const std::vector<std::string>& files = {});

/// An array of `coordinates` per vertex as a LarModel, for makers and tests.
LarModel lar_model(std::size_t dimension, const std::vector<Rational>& coordinates,
                   std::vector<Cells> cells);

/// The model under a map. Throws: Error BadInput for a map of another dimension. Source: larApply
/// (larstruct 2015, 1.2).
LarModel apply(const Affine& map, LarModel model);
/// The model with k coordinates 0 more per vertex; for k < 0 without its last -k coordinates.
/// Throws: Error BadInput where none would be left. Source: larEmbed (larstruct 2015, 3.2).
LarModel embed(const LarModel& model, int k);
/// The segments as a model (V, EV), a vertex for each end.
LarModel lar_model(const Model& model);

/// The grid of unit cubes [0, shape[0]] x [0, shape[1]] x ... of any dimension: vertices at the
/// integer points, the last coordinate fastest, cells in the same order. With `skeletons` also its
/// cells of dimensions d-1, ..., 0, those with the first coordinates free last. Degenerate: an
/// extent of 0 has vertices but no d-cells. Throws: Error BadInput for dimension 0, Limit beyond 24
/// dimensions and kMaxGridNumbers coordinates or indices. Source:
/// larCuboids of larcc's module largrid.
LarModel cuboids(const std::vector<std::uint32_t>& shape, bool skeletons = false);
inline constexpr std::uint64_t kMaxGridNumbers = std::uint64_t{1} << 25U;

/// The cells of dimension k+1 spanned by an apex and k-cells: the cone over them; over the edges of
/// a polygon the fan of triangles. Cells that hold the apex are left out.
Cells simplicial_fan(const Cells& cells, std::uint32_t apex);

/// The facets that an odd number of the cells hold: the boundary (mod 2) of the chain of all cells,
/// as indices into cells[k + 1], ascending. A cell holds a facet whose vertices are all among its
/// own; LAR's rule, right where cells are convex, wrong for a cell that holds all vertices of a
/// facet without bordering on it. Requires: k + 1 < model.cells.size().
std::vector<std::uint32_t> boundary_cells(const LarModel& model, std::size_t k = 0);
/// The incidences behind it: per facet in cells[k + 1] the cells of cells[k] that hold it.
Cells facet_cells(const LarModel& model, std::size_t k = 0);
/// (V, boundary facets), all vertices kept. Requires: two arrays of cells.
LarModel boundary_model(const LarModel& model);
/// The edges of a model (V, FV, EV)'s boundary, or of a model (V, EV), as closed polylines of
/// vertex indices, the first not repeated. Each is simple: where the walk meets itself a polyline
/// is split off; begins with the least vertex that is left, walks to the lower neighbour first. An
/// edge that is there twice counts once. Throws: Error BadInput where the boundary edges do not
/// close (an odd number meet in a vertex).
Cells boundary_polylines(const LarModel& model);

/// What a model of the plane draws: its edges as pairs of vertices, each once, and the cells that
/// can't be drawn.
struct ModelEdges {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::pair<std::uint32_t, std::string>> refused;  ///< cell and reason
};

/// The edges of a model's last array, of those with other cells than single vertices: EV in
/// (V, FV, EV). A cell of two vertices is an edge. A cell
/// of more vertices of which no edges are given is the polygon of its vertices in their order where
/// that is simple; else, as for MKPOL, the convex hull, where every vertex lies on its boundary;
/// else it is refused, as are cells of one vertex, of repeated vertices and of more than
/// kMaxPolygon vertices. **Exact**. Cost: quadratic in the vertices of a cell at worst.
ModelEdges edges(const LarModel& model);
inline constexpr std::size_t kMaxPolygon = 10'000;

/// (V, sides that an odd number of the cells of the first array have): the boundary mod 2 of a
/// model of the plane, its cells taken as the polygons that `edges` draws, whatever their shape.
/// Throws: Error BadInput for a cell that can't be drawn and for one of two vertices, which has no
/// sides.
LarModel polygon_boundary(const LarModel& model);

}  // namespace plumbline
