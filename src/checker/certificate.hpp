#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "input.hpp"
#include "number.hpp"

namespace plumbline_checker {

using Index = std::uint32_t;
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

struct Edge {
  Index tail, head;  ///< tail < head
};
/// The halfedges of an edge.
inline Index along(Index edge) { return 2 * edge; }
inline Index against(Index edge) { return 2 * edge + 1; }

/// What a certificate says. Of its vertices and edges it is known that they are well-formed, refer
/// to what there is, and come in their order; everything else is text still.
struct Certificate {
  std::string_view signature;
  std::vector<Point> vertices;            ///< strictly ascending
  std::vector<std::string_view> reasons;  ///< of each vertex
  std::vector<Edge> edges;                ///< strictly ascending by (tail, head)
  Lists segments;             ///< that cover each edge, strictly ascending, at least one
  std::vector<Index> pieces;  ///< which piece of the segment an edge is, as segments.values
  std::vector<std::string_view> cycles, faces,
      components;                        ///< lines; of faces what is before " inside"
  std::vector<std::string_view> inside;  ///< of each face what is after it

  /// The line of the text on which a section's first item is.
  std::size_t vertex_line = 0, edge_line = 0, cycle_line = 0, face_line = 0, component_line = 0;

  /// Throw a Refusal: what is wrong with an item, on its line, at its place.
  [[noreturn]] void refuse_vertex(Index v, const std::string& problem) const;
  [[noreturn]] void refuse_edge(Index e, const std::string& problem, const Point& place) const;
};

/// Reads a certificate. Throws: Refusal.
Certificate read_certificate(std::string_view text, const Input& input);

/// Throws a Refusal where a line, or a part of it, is not what is right.
void require(const std::string& item, std::string_view said, std::string_view right,
             std::size_t line, const Point* place = nullptr);

}  // namespace plumbline_checker
