#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumbline/engines/lar.hpp"

namespace plumbline {
struct Engine;
}

/// LAR's module `inters` as it was published (Paoluzzi, "Accelerated intersection of geometric
/// objects", November 2015), with its fixed decimals, its omissions and its order: the variant
/// `published` of the float pipeline, there to reproduce and study results of the original.
///
/// Every list has the order of the original run under Python 2.7, whose sets and dictionaries list
/// their keys by hash: numbering and, where merging made a drawing non-planar, even the faces
/// depend on it. Everything is **Rounded** and right only where the original was. Where the
/// original crashed or ran for ever, the stage is a `Failure`.
namespace plumbline::inters {

/// The default number of decimals of the original's `vcode`.
inline constexpr int kDecimals = 4;
/// Most decimals: coordinates are written with 12 significant digits.
inline constexpr int kMaxDecimals = 12;
/// The original's radius of pruning, in drawing units.
inline constexpr double kRadius = 0.001;

/// Most cycles whose containment `run` compares, each with each.
inline constexpr std::size_t kMaxLattice = 1000;

/// What the pipeline answers.
enum class Result {
  LarFromLines,     ///< faces of the component with most edges
  AllComponents,    ///< faces of all components, as in the document's tests 08 and 09
  CellsFromCycles,  ///< cells with holes; every component must be a simple cycle
};

struct Options {
  int decimals = kDecimals;
  double radius = kRadius;
  /// At most so many (and 1024); 0: as many as there are cores. Does not change the result.
  std::size_t threads = 0;
};

using lar::Box;
using lar::Model;
using lar::VertexPair;

/// A quantised input segment and where it is cut. Equal ones are one fragment, reversed ones two.
struct Fragment {
  SegmentD segment;
  std::vector<double> parameters;  ///< ascending, quantised

  friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// Vertices merged within the radius, transitively.
struct Pruned {
  std::vector<PointD> vertices;  ///< centroids, not quantised, in the order of their least members
  std::vector<VertexId> vertex_map;
  Lists<VertexId> clusters;       ///< those of two or more members
  std::vector<VertexPair> close;  ///< pairs within the radius, ascending
};

/// Faces found by traversal, the exterior ones included.
struct Faces {
  Model model;
  std::vector<double> areas;  ///< per face, absolute, computed in single precision
  /// The walk met a vertex that its edge does not bound, and stopped: the rest of the faces is
  /// missing.
  bool aborted = false;
};

/// Why a stage has no output.
struct Failure {
  std::string stage;     ///< the key of the output that is missing
  std::string error;     ///< what the original raised; NoTermination where it ran for ever, Limit
                         ///< where we stop
  std::string message;   ///< what happened
  std::string function;  ///< the original's function that failed

  friend bool operator==(const Failure&, const Failure&) = default;
};

/// Either a value or why there is none.
template <class T>
struct Outcome {
  std::optional<T> value;
  std::optional<Failure> failure;
};

/// Per polygon (row) and cycle (column) where the cycle's first vertex lies: 1 inside, 0 outside,
/// -1 on the boundary.
using LatticeArray = std::vector<std::vector<int>>;
/// Per cell its outer cycle, then its holes.
using CycleCells = std::vector<std::vector<std::size_t>>;
using Polyline = std::vector<PointD>;             ///< closed: the first point is also the last
using SignedCycle = std::vector<std::ptrdiff_t>;  ///< edges, negative when reversed; 0 has no sign

/// The containment lattice of the components that are simple cycles.
struct SimpleCycles {
  std::vector<std::size_t> components;
  LatticeArray lattice;
  CycleCells cells;
};

/// The pipeline of the document's tests 08 and 09: the union of all components.
struct AllComponents {
  Faces faces;
  std::vector<std::size_t> interior;  ///< faces whose area is not the largest
};

/// The output of every stage, in their order; none where a stage failed or had nothing to work on.
struct Trace {
  Options options;
  std::vector<SegmentD> lines;              ///< the input
  std::vector<Box> boxes;                   ///< per segment, quantised
  Lists<SegmentId> buckets;                 ///< per segment, the others that share a bucket
  std::vector<PointD> intersection_points;  ///< quantised, ascending
  std::vector<Fragment> fragments;
  Model raw;  ///< split segments; each pair of vertices once
  std::size_t raw_edge_count_with_duplicates = 0;
  Pruned prune;
  Model lar;                                        ///< result of lines2lar
  std::vector<std::vector<VertexPair>> components;  ///< biconnected, of two or more edges
  std::vector<VertexPair> bridges;      ///< edges in no cycle, dangling ones too: what is dropped
  std::optional<Faces> largest;         ///< of the component with most edges
  std::optional<Model> lar_from_lines;  ///< the result; none where no component is
  std::optional<AllComponents> all_components;
  std::vector<Outcome<std::vector<Polyline>>> boundary_polylines;  ///< per component
  std::vector<Outcome<std::vector<SignedCycle>>> boundary_cycles;  ///< per component
  std::optional<LatticeArray> lattice;  ///< this and the other lattice: up to kMaxLattice cycles
  std::optional<CycleCells> cells;
  std::optional<Model> two_complex;  ///< of the cells: faces are the vertices of their cycles
  std::optional<std::vector<std::vector<VertexPair>>> bridge_edges;  ///< per cell
  std::optional<SimpleCycles> simple_cycles;  ///< only where not all components are simple
  std::optional<LatticeArray> faces_lattice;  ///< of the faces of the result
  std::vector<Failure> failures;
};

/// The segments in doubles, in their order, neither made unique nor turned.
std::vector<SegmentD> lines(const SegmentSet& input);

/// The segments mapped to the unit square and quantised as the original's SVG input: the longer
/// side becomes 1, the shorter one starts at 0, the top is 1, y is turned upwards. Throws: Error
/// BadInput for a drawing without width or height, by which the original divides.
std::vector<SegmentD> lines_on_unit_square(const SegmentSet& input, int decimals = kDecimals);

/// Runs the published pipeline (section 2.8, `larFromLines`, and what the document's tests do with
/// its stages). Degenerate: what the original cannot do is a failure in the trace, and the stages
/// that need it are missing. Cost: as the original's, buckets of long segments grow without bound.
/// Throws: Error BadInput for decimals outside 0 to kMaxDecimals or a radius that is not positive
/// and finite; Limit where buckets, or the pairs of vertices within the radius, outgrow memory.
Trace run(std::vector<SegmentD> lines, const Options& options = {});

/// What the engine is given apart from the drawing.
struct Original {
  /// The lines in place of the input's, in their order; by default these are its nearest doubles.
  /// For maps done in floats, as that to the unit square.
  std::optional<std::vector<SegmentD>> lines = {};
  /// The SVG text that the input was read from: then what the published svg2lines would misread is
  /// found, too.
  std::optional<std::string> svg = {};
};
/// The pipeline as an engine for `check`, with the parameters radius, decimals and result
/// (larFromLines, allComponents, cells); its name is "inters".
Engine engine(Original original = {});

/// The model over merged vertices: (V, EV) where it has no faces, or (V, FV, EV), where edges that
/// became a point stay (Q10). Cells in the order of sets, faces then by length; vertices stay, used
/// or not. Section 2.9 (larSimplify). Throws: Error BadInput for a model without edges, or a cell
/// with a vertex that the model has not; as `run` for the radius.
Model simplify(const Model& model, double radius = kRadius);

/// The edges that bound a chain of faces, modulo 2: an edge is incident to the faces that have both
/// its vertices. Ascending. Section 2.11 (chain2BoundaryChain). Throws: Error BadInput for a face
/// that the model has not.
std::vector<std::size_t> boundary_chain(const Model& model, std::span<const std::size_t> faces);

}  // namespace plumbline::inters
