#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {
struct Engine;
}

/// The 2D arrangement of Plasm.jl (`ARRANGE2D`, version 1.0.4): LAR as it lives today, there to
/// reproduce and study its results. Everything is **Rounded** and right only where the original is.
/// Numbers of vertices and edges are the original's, since which vertices are merged and which face
/// takes a hole depend on them. Where the original crashes or runs for ever there is a `Failure`.
/// The stages are in `plasm_stages.hpp`.
namespace plumbline::plasm {

/// LAR_DEFAULT_ERR: of lengths, of parameters and of cosines alike.
inline constexpr double kRadius = 1e-8;

using VertexPair = std::array<VertexId, 2>;  ///< an edge, lesser number first

/// A graph (V, EV) in the plane. Double edges, and vertices of no edge, may be there.
struct Graph {
  std::vector<PointD> vertices;
  std::vector<VertexPair> edges;
  Lists<SegmentId> edge_sources;  ///< per edge, ascending: the input segments that it is part of
};

/// An edge with its coefficient: 1 from the lesser vertex to the greater one, -1 against it. What
/// goes round edges that cross may have others.
struct SignedEdge {
  EdgeId edge;
  int sign = 1;
  friend bool operator==(const SignedEdge&, const SignedEdge&) = default;
};
using Chain = std::vector<SignedEdge>;  ///< ascending by edge

/// What merging near vertices did.
struct Merging {
  std::vector<VertexId> vertex_map;  ///< old vertex -> new vertex
  std::vector<VertexId> kept;        ///< new vertex -> the old vertex that it is
  Graph graph;                       ///< without edges that became a point, double edges once
};

/// The faces of a biconnected component.
struct Component {
  std::vector<EdgeId> edges;  ///< ascending
  std::vector<Chain> faces;   ///< bounded ones, in the order in which they were found
  Chain shell;                ///< the boundary of the unbounded face
};

/// A component as the hole of a face of another one.
struct Hole {
  std::size_t father = 0;  ///< component
  std::size_t face = 0;    ///< of the father
  std::size_t child = 0;   ///< component
  friend bool operator==(const Hole&, const Hole&) = default;
};

/// Why there is no result.
struct Failure {
  enum class Kind {
    NoCycle,      ///< no edge is in a cycle, which the original cannot return
    EndlessWalk,  ///< the walk round a face never closes
    NoShell       ///< no face looks like the unbounded one
  };
  Kind kind = Kind::NoCycle;
  std::string message;
};

/// The output of every stage.
struct Trace {
  double radius = kRadius;
  Graph drawing;               ///< the segments in doubles, as they come
  std::vector<PointD> points;  ///< isolated ones, for which no later stage has a place
  Graph fragments;             ///< cut, each piece with vertices of its own
  Merging merging;
  std::vector<std::vector<EdgeId>> components;  ///< of two or more edges; most edges first
  std::vector<EdgeId> dropped;                  ///< edges in no cycle, ascending
  std::vector<Component> cells;                 ///< of the components, as far as they were found
  std::vector<Hole> holes;
  std::optional<Failure> failure;
};

/// Runs the stages one after the other. Degenerate: isolated points and segments that round to a
/// point are left out, as the original has no edge for them. Cost: as `fragment`, `merge` and
/// `nest`. Throws: Error BadInput for a radius that is negative or not finite, or a coordinate of
/// more than 2^500, whose products overflow; Limit as `fragment`.
Trace run(const SegmentSet& input, double radius = kRadius);

/// The same as an engine for `check`, with the parameter radius; its name is "plasm".
Engine engine();

}  // namespace plumbline::plasm
