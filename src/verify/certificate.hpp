#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "input.hpp"
#include "number.hpp"

namespace plumbline_verify {

using Index = std::uint32_t;
/// "-" in a certificate; also: no edge, not yet known.
inline constexpr Index kNone = 0xFFFFFFFF;

/// Lists of numbers, one after the other.
struct Lists {
  std::vector<Index> begins = {0};  ///< one more than there are lists
  std::vector<Index> values;

  std::size_t size() const { return begins.size() - 1; }
  const Index* begin(std::size_t list) const { return values.data() + begins[list]; }
  const Index* end(std::size_t list) const { return values.data() + begins[list + 1]; }
  void close() { begins.push_back(static_cast<Index>(values.size())); }
};

/// Why there is a vertex.
struct Definer {
  enum class Kind : std::uint8_t { End, Cross, Point };
  Kind kind = Kind::End;
  Index first = kNone;   ///< segment or point
  Index second = kNone;  ///< end 0 or 1, or the other segment

  bool operator==(const Definer&) const = default;
};

struct Edge {
  Index tail, head;  ///< tail < head
};
/// The halfedges of an edge.
inline Index along(Index edge) { return 2 * edge; }
inline Index against(Index edge) { return 2 * edge + 1; }

struct Face {
  Index outer, depth, parent;
};

struct Component {
  Index least_vertex, face;
};

/// A certificate as its text has it. The indices that the first half (vertices, edges) refers to
/// exist, tail < head, and numbers are in lowest terms; nothing else is known.
struct Certificate {
  std::string_view signature;
  std::vector<Point> vertices;
  std::vector<Definer> definers;  ///< of each vertex
  std::vector<Edge> edges;
  Lists segments;             ///< that cover each edge, ascending, at least one
  std::vector<Index> pieces;  ///< which piece of the segment the edge is, as segments.values
  Lists cycles;               ///< of halfedges
  std::vector<Face> faces;
  Lists holes, isolated;      ///< of each face
  std::vector<Point> inside;  ///< of each face but face 0
  std::vector<Component> components;

  /// The line of the text on which a section's first item is.
  std::size_t vertex_line = 0, edge_line = 0, cycle_line = 0, face_line = 0, component_line = 0;
};

/// Reads a certificate. Throws: Refusal.
Certificate read_certificate(std::string_view text, const Input& input);

}  // namespace plumbline_verify
