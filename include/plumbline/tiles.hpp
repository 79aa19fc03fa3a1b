#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

/// Arrangements in tiles, of which none needs the others: strips of the plane between upright cuts.
/// What they have together follows from the order of lines along the cuts alone, without geometry.
namespace plumbline::tiles {

/// 128 bits that name a cell by its geometry, and add up in any order.
struct CellHash {
  std::uint64_t low = 0, high = 0;

  CellHash& operator+=(const CellHash& other) {
    low += other.low;
    high += other.high;
    return *this;
  }
  friend auto operator<=>(const CellHash&, const CellHash&) = default;
};

/// 32 hexadecimal digits.
std::string to_text(const CellHash& hash);

/// A signature that adds up over tiles: the sum of hashes of all cells, each named by its geometry
/// and not by a number. A vertex is named by its coordinates modulo two primes, an edge by its
/// ends, a corner by three vertices, a cycle by the sum of its halfedges, a face by the sum of its
/// cycles and by whether it is bounded. Equal for equal subdivisions whatever the input, engine or
/// number of tiles; sources do not count. Good against accident, not against an adversary. Cost:
/// linear.
CellHash signature2(const ExactComplex& complex);

/// Where a strip begins and ends: nowhere at the outer ones.
struct Strip {
  std::optional<Number> left, right;
};

/// Box of the whole drawing.
struct Bounds {
  Number left, bottom, right, top;
};

/// How a cell hangs together with what lies in other strips. A port is where a line crosses a cut.
inline constexpr std::uint32_t kNone = UINT32_MAX;
enum Side : std::uint32_t { kLeft, kRight };

/// Part of an edge that crosses a cut: its lexicographically first end, and its other one, where
/// they lie in this strip.
struct EdgePiece {
  std::uint32_t component = kNone;  ///< among those that cross cuts
  bool has_tail = false, has_head = false;
  CellHash tail, head;
};

struct Port {
  std::uint64_t segment = 0;    ///< the least that covers the edge, a number of the whole drawing
  std::uint32_t piece = kNone;  ///< of this strip
};

/// What parts of the border lie along a cut.
struct Border {
  std::vector<Port> ports;           ///< upwards
  std::vector<std::uint32_t> faces;  ///< before, between and behind them: open faces of this strip
};

/// Halfedges of a cycle from port to port, with the face on their left.
struct Chain {
  std::uint32_t start_side = kNone, start = kNone, end_side = kNone, end = kNone;
  std::uint32_t face = kNone;
  CellHash sum;  ///< of halfedges that lie in the strip as a whole
  /// The halfedge that leaves, where it begins in this strip.
  std::uint32_t leaves = kNone;  ///< its piece
  bool reversed = false;         ///< whether it runs against the edge
};

/// Halfedges that follow each other at a vertex, of which one at least crosses a cut.
struct Corner {
  CellHash vertex, before, behind;
  std::uint32_t before_piece = kNone, behind_piece = kNone;  ///< whose far end is not known here
  bool before_reversed = false, behind_reversed = false;
};

/// A face of the strip that reaches its border, and what is known of it.
struct OpenFace {
  CellHash cycles;          ///< sum of the names of holes within the strip
  std::uint64_t holes = 0;  ///< how many
  bool unbounded = false;
};

/// Numbers of cells, the unbounded face included, holes of bounded faces only.
struct Totals {
  std::uint64_t vertices = 0, edges = 0, faces = 0, holes = 0, components = 0;
  CellHash signature;

  friend bool operator==(const Totals&, const Totals&) = default;
};

/// What lies in a strip, counted and signed, and what goes on in others.
struct StripPart {
  Totals closed;  ///< cells of this strip alone
  Border borders[2];
  std::vector<EdgePiece> pieces;
  std::uint32_t components = 0;  ///< how many cross cuts
  std::vector<Chain> chains;
  std::vector<Corner> corners;
  std::vector<OpenFace> faces;
};

/// What a cut goes through: then another one is to be chosen.
struct CutThroughVertex {
  Side side;
};

/// The arrangement within a strip. `segments` are those that meet it, `numbers` their numbers in
/// the whole drawing, ascending. **Exact**. Degenerate: an empty strip is one face. Throws:
/// CutThroughVertex where a vertex lies on a cut, or a segment runs along it; as `arrange`.
StripPart strip_part(SegmentSet segments, std::span<const std::uint64_t> numbers,
                     const Strip& strip, const Bounds& bounds, std::size_t threads = 1);

/// What strips from left to right are together. Cost: O(n log n) for all that crosses cuts.
/// Throws: Error Internal where two strips tell of other lines at the cut between them, or V - E +
/// F is not 1 + C.
Totals merged(std::span<const StripPart> parts);

}  // namespace plumbline::tiles
