// A strip's own arrangement: its segments and the frame of the strip are arranged, and what lies
// outside of the frame is left out.

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "tiles/cell_hash.hpp"

namespace plumbline::tiles {
namespace {

/// The sides of the frame, as segments behind those of the drawing.
enum FrameSide : std::uint8_t { kLeftSide, kRightSide, kBottomSide, kTopSide, kNoSide };

SegmentSet framed(SegmentSet segments, const Strip& strip, const Bounds& bounds) {
  SegmentSet result;
  const SourceId source = result.add_source({});
  result.segment_source.assign(segments.segments.size(), source);
  result.segments = std::move(segments.segments);
  const Number one = Number::decimal(1, 0);
  const Number left = strip.left.value_or(bounds.left - one),
               right = strip.right.value_or(bounds.right + one);
  const Number bottom = bounds.bottom - one, top = bounds.top + one;
  result.add(NumberPoint{left, bottom}, NumberPoint{left, top}, source);
  result.add(NumberPoint{right, bottom}, NumberPoint{right, top}, source);
  result.add(NumberPoint{left, bottom}, NumberPoint{right, bottom}, source);
  result.add(NumberPoint{left, top}, NumberPoint{right, top}, source);
  return result;
}

class Inside {
 public:
  Inside(ExactComplex complex, std::span<const std::uint64_t> numbers, const Strip& strip)
      : complex_(std::move(complex)), numbers_(numbers), strip_(strip) {}

  StripPart part() {
    find_frame();
    find_inside();
    find_ports();
    hash_vertices();
    add_edges();
    add_components();
    add_cycles();
    add_faces();
    return std::move(part_);
  }

 private:
  /// Which side of the frame each edge lies on.
  void find_frame() {
    side_.assign(complex_.edge_count(), kNoSide);
    on_frame_.assign(complex_.vertices.size(), false);
    for (std::size_t e = 0; e < side_.size(); ++e) {
      const SegmentId last = complex_.edge_sources[e].back();
      if (last < numbers_.size()) continue;
      side_[e] = static_cast<FrameSide>(last - numbers_.size());
      if (complex_.edge_sources[e].size() > 1) {
        throw CutThroughVertex{side_[e] == kLeftSide ? kLeft : kRight};
      }
      on_frame_[complex_.edges[e].tail] = on_frame_[complex_.edges[e].head] = true;
    }
  }

  /// Frame edges run to the right and upwards: inside is on their left at the right and below.
  HalfedgeId inner(EdgeId e) const {
    return halfedge(e, side_[e] == kLeftSide || side_[e] == kTopSide);
  }

  /// What hangs together without crossing the frame is inside as a whole, or outside.
  void find_inside() {
    UnionFind sets(complex_.face_count());
    std::size_t within = 0;
    for (std::size_t e = 0; e < side_.size(); ++e) {
      if (side_[e] == kNoSide) {
        sets.unite(face(EdgeId(e), false), face(EdgeId(e), true));
      } else {
        within = complex_.halfedge_face[inner(EdgeId(e))];
      }
    }
    is_inside_.resize(complex_.face_count());
    for (std::size_t f = 0; f < is_inside_.size(); ++f) {
      is_inside_[f] = sets.find(f) == sets.find(within);
    }
    open_.assign(complex_.face_count(), kNone);
    for (std::size_t e = 0; e < side_.size(); ++e) {
      if (side_[e] == kNoSide) continue;
      std::uint32_t& open = open_[complex_.halfedge_face[inner(EdgeId(e))]];
      if (open == kNone) {
        open = static_cast<std::uint32_t>(part_.faces.size());
        part_.faces.emplace_back();
      }
      const bool is_hull = (side_[e] == kLeftSide && !strip_.left) ||
                           (side_[e] == kRightSide && !strip_.right) || side_[e] == kBottomSide ||
                           side_[e] == kTopSide;
      if (is_hull) part_.faces[open].unbounded = true;
    }
  }

  FaceId face(EdgeId e, bool reversed) const {
    return complex_.halfedge_face[halfedge(e, reversed)];
  }
  bool is_inner(EdgeId e) const { return side_[e] == kNoSide && is_inside_[face(e, false)]; }

  /// Along the cuts upwards, as edges of one line are in order. A port has the frame's two edges
  /// and one on either side.
  void find_ports() {
    port_.assign(complex_.vertices.size(), {kNone, kNone});
    for (const Side side : {kLeft, kRight}) {
      if (side == kLeft ? !strip_.left : !strip_.right) continue;
      Border& border = part_.borders[side];
      for (std::size_t e = 0; e < side_.size(); ++e) {
        if (side_[e] != (side == kLeft ? kLeftSide : kRightSide)) continue;
        if (!border.faces.empty()) {
          port_[complex_.edges[e].tail] = {side, static_cast<std::uint32_t>(border.ports.size())};
          border.ports.emplace_back();
        }
        border.faces.push_back(open_[complex_.halfedge_face[inner(EdgeId(e))]]);
      }
    }
    std::vector<std::uint32_t> degree(complex_.vertices.size());
    for (const Edge& e : complex_.edges) ++degree[e.tail], ++degree[e.head];
    for (std::size_t v = 0; v < degree.size(); ++v) {
      constexpr std::uint32_t kOfPort = 4;
      if (port_[v].first != kNone && degree[v] != kOfPort) {
        throw CutThroughVertex{static_cast<Side>(port_[v].first)};
      }
    }
  }

  void hash_vertices() {
    is_ours_.assign(complex_.vertices.size(), false);
    hash_.resize(complex_.vertices.size());
    for (std::size_t e = 0; e < side_.size(); ++e) {
      if (!is_inner(EdgeId(e))) continue;
      for (const VertexId v : {complex_.edges[e].tail, complex_.edges[e].head}) {
        if (on_frame_[v] || is_ours_[v]) continue;
        is_ours_[v] = true;
        hash_[v] = vertex_hash(complex_.vertices, v);
        part_.closed.signature += hash_[v];
        ++part_.closed.vertices;
      }
    }
  }

  void add_edges() {
    piece_.assign(side_.size(), kNone);
    for (std::size_t e = 0; e < side_.size(); ++e) {
      if (!is_inner(EdgeId(e))) continue;
      const auto [tail, head] = complex_.edges[e];
      if (is_ours_[tail] && is_ours_[head]) {
        part_.closed.signature += edge_hash(hash_[tail], hash_[head]);
        ++part_.closed.edges;
        continue;
      }
      piece_[e] = static_cast<std::uint32_t>(part_.pieces.size());
      EdgePiece piece;
      piece.has_tail = is_ours_[tail];
      piece.has_head = is_ours_[head];
      if (piece.has_tail) piece.tail = hash_[tail];
      if (piece.has_head) piece.head = hash_[head];
      part_.pieces.push_back(piece);
      for (const VertexId v : {tail, head}) {
        if (is_ours_[v]) continue;
        const auto [side, place] = port_[v];
        ensure(side != kNone, "an edge leaves a strip through a port");
        part_.borders[side].ports[place] = {numbers_[complex_.edge_sources[e].front()], piece_[e]};
      }
    }
  }

  /// Vertices that hang together within the strip.
  void add_components() {
    UnionFind sets(complex_.vertices.size() + part_.pieces.size());
    for (std::size_t e = 0; e < side_.size(); ++e) {
      if (!is_inner(EdgeId(e))) continue;
      const auto [tail, head] = complex_.edges[e];
      const std::size_t of_edge = piece_[e] == kNone ? tail : complex_.vertices.size() + piece_[e];
      if (is_ours_[tail]) sets.unite(of_edge, tail);
      if (is_ours_[head]) sets.unite(of_edge, head);
    }
    std::vector<std::uint32_t> number(complex_.vertices.size() + part_.pieces.size(), kNone);
    for (std::size_t p = 0; p < part_.pieces.size(); ++p) {
      std::uint32_t& component = number[sets.find(complex_.vertices.size() + p)];
      if (component == kNone) component = part_.components++;
      part_.pieces[p].component = component;
    }
    for (std::size_t v = 0; v < is_ours_.size(); ++v) {
      if (is_ours_[v] && sets.find(v) == v && number[v] == kNone) ++part_.closed.components;
    }
  }

  void add_cycles() {
    closed_faces_.resize(complex_.face_count());
    for (std::size_t c = 0; c < complex_.cycles.size(); ++c) {
      const FaceId of = complex_.cycle_face[c];
      if (!is_inside_[of]) continue;
      const auto cycle = complex_.cycles[c];
      const auto on_frame = std::find_if(
          cycle.begin(), cycle.end(), [&](HalfedgeId h) { return side_[edge_of(h)] != kNoSide; });
      if (on_frame == cycle.end()) {
        add_whole(cycle, of);
      } else {
        add_chains(cycle, static_cast<std::size_t>(on_frame - cycle.begin()), of);
      }
    }
  }

  void add_whole(std::span<const HalfedgeId> cycle, FaceId of) {
    CellHash halfedges;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      halfedges +=
          halfedge_hash(hash_[complex_.origin(cycle[i])], hash_[complex_.target(cycle[i])]);
      add_corner(cycle[i], cycle[i + 1 == cycle.size() ? 0 : i + 1]);
    }
    const CellHash name = cycle_hash(halfedges);
    if (open_[of] == kNone) {
      closed_faces_[of] += name;
    } else {
      part_.faces[open_[of]].cycles += name;
      ++part_.faces[open_[of]].holes;
    }
  }

  /// What lies between edges of the frame.
  void add_chains(std::span<const HalfedgeId> cycle, std::size_t on_frame, FaceId of) {
    std::vector<HalfedgeId> chain;
    for (std::size_t i = 1; i <= cycle.size(); ++i) {
      const HalfedgeId h = cycle[(on_frame + i) % cycle.size()];
      if (side_[edge_of(h)] == kNoSide) {
        chain.push_back(h);
      } else if (!chain.empty()) {
        add_chain(chain, of);
        chain.clear();
      }
    }
  }

  void add_chain(const std::vector<HalfedgeId>& chain, FaceId of) {
    Chain made;
    std::tie(made.start_side, made.start) = port_[complex_.origin(chain.front())];
    std::tie(made.end_side, made.end) = port_[complex_.target(chain.back())];
    made.face = open_[of];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (piece_[edge_of(chain[i])] == kNone) {
        made.sum +=
            halfedge_hash(hash_[complex_.origin(chain[i])], hash_[complex_.target(chain[i])]);
      }
      if (i + 1 < chain.size()) add_corner(chain[i], chain[i + 1]);
    }
    if (is_ours_[complex_.origin(chain.back())]) {
      made.leaves = piece_[edge_of(chain.back())];
      made.reversed = is_reversed(chain.back());
    }
    part_.chains.push_back(made);
  }

  /// At the vertex between two halfedges, which is ours.
  void add_corner(HalfedgeId h, HalfedgeId next) {
    Corner corner;
    corner.vertex = hash_[complex_.target(h)];
    if (is_ours_[complex_.origin(h)]) {
      corner.before = hash_[complex_.origin(h)];
    } else {
      corner.before_piece = piece_[edge_of(h)];
      corner.before_reversed = is_reversed(h);
    }
    if (is_ours_[complex_.target(next)]) {
      corner.behind = hash_[complex_.target(next)];
    } else {
      corner.behind_piece = piece_[edge_of(next)];
      corner.behind_reversed = is_reversed(next);
    }
    if (corner.before_piece == kNone && corner.behind_piece == kNone) {
      part_.closed.signature += corner_hash(corner.before, corner.vertex, corner.behind);
    } else {
      part_.corners.push_back(corner);
    }
  }

  /// Those that do not reach the border.
  void add_faces() {
    for (std::size_t f = 0; f < is_inside_.size(); ++f) {
      if (!is_inside_[f] || open_[f] != kNone) continue;
      part_.closed.signature += face_hash(closed_faces_[f], true);
      part_.closed.holes += complex_.face_holes[f].size();
      ++part_.closed.faces;
    }
  }

  ExactComplex complex_;
  std::span<const std::uint64_t> numbers_;
  const Strip& strip_;
  StripPart part_;
  std::vector<FrameSide> side_;                                ///< per edge
  std::vector<bool> on_frame_, is_ours_;                       ///< per vertex
  std::vector<std::pair<std::uint32_t, std::uint32_t>> port_;  ///< per vertex, side and place
  std::vector<bool> is_inside_;                                ///< per face
  std::vector<std::uint32_t> open_;                            ///< per face, its number
  std::vector<std::uint32_t> piece_;                           ///< per edge
  std::vector<CellHash> hash_;                                 ///< per vertex that is ours
  std::vector<CellHash> closed_faces_;                         ///< per face, sum of its cycles
};

}  // namespace

StripPart strip_part(SegmentSet segments, std::span<const std::uint64_t> numbers,
                     const Strip& strip, const Bounds& bounds, std::size_t threads) {
  ensure(numbers.size() == segments.segments.size(), "each segment has a number");
  ArrangeOptions options;
  options.threads = threads;
  ExactComplex complex =
      arrange(framed(std::move(segments), strip, bounds), ExactEngine::Bucket, options);
  return Inside(std::move(complex), numbers, strip).part();
}

}  // namespace plumbline::tiles
