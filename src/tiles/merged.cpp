// What strips are together: everything is united through ports and the parts of borders between
// them, by numbers alone.

#include <utility>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/error.hpp"
#include "tiles/cell_hash.hpp"

namespace plumbline::tiles {
namespace {

/// Where the things of each strip begin in the numbers of all.
class Offsets {
 public:
  template <class CountOf>
  Offsets(std::span<const StripPart> parts, CountOf count_of) {
    for (const StripPart& part : parts) {
      begin_.push_back(all_);
      all_ += count_of(part);
    }
  }
  std::size_t of(std::size_t part, std::size_t i) const { return begin_[part] + i; }
  std::size_t all() const { return all_; }

 private:
  std::vector<std::size_t> begin_;
  std::size_t all_ = 0;
};

class Merging {
 public:
  explicit Merging(std::span<const StripPart> parts)
      : parts_(parts),
        pieces_(parts, [](const StripPart& p) { return p.pieces.size(); }),
        components_(parts, [](const StripPart& p) { return p.components; }),
        chains_(parts, [](const StripPart& p) { return p.chains.size(); }),
        faces_(parts, [](const StripPart& p) { return p.faces.size(); }),
        edges_(pieces_.all()),
        whole_components_(components_.all()),
        cycles_(chains_.all()),
        whole_faces_(faces_.all() + 1) {}

  Totals run() {
    for (const StripPart& part : parts_) add(part.closed);
    for (std::size_t i = 0; i + 1 < parts_.size(); ++i) join(i);
    add_edges();
    add_corners();
    add_components();
    add_faces(names_of_cycles());
    ensure(totals_.vertices + totals_.faces == totals_.edges + 1 + totals_.components,
           "V - E + F is 1 + C of all strips together");
    return totals_;
  }

 private:
  void add(const Totals& closed) {
    totals_.vertices += closed.vertices;
    totals_.edges += closed.edges;
    totals_.faces += closed.faces;
    totals_.holes += closed.holes;
    totals_.components += closed.components;
    totals_.signature += closed.signature;
  }

  /// Unites what lies on both sides of the cut between strips i and i + 1.
  void join(std::size_t i) {
    const Border &left = parts_[i].borders[kRight], &right = parts_[i + 1].borders[kLeft];
    ensure(left.ports.size() == right.ports.size() && left.faces.size() == right.faces.size(),
           "two strips have the same ports at the cut between them");
    for (std::size_t k = 0; k < left.faces.size(); ++k) {
      whole_faces_.unite(faces_.of(i, left.faces[k]), faces_.of(i + 1, right.faces[k]));
    }
    std::vector<std::size_t> starts(2 * left.ports.size()), ends(2 * left.ports.size());
    for (std::size_t k = 0; k < left.ports.size(); ++k) {
      const Port &p = left.ports[k], &q = right.ports[k];
      ensure(p.segment == q.segment, "ports are of the same segments");
      edges_.unite(pieces_.of(i, p.piece), pieces_.of(i + 1, q.piece));
      whole_components_.unite(components_.of(i, parts_[i].pieces[p.piece].component),
                              components_.of(i + 1, parts_[i + 1].pieces[q.piece].component));
    }
    // Rightwards through a port in the first half, leftwards in the second one.
    const auto note = [&](std::size_t strip, Side side) {
      const bool is_right = side == kLeft;
      for (std::size_t c = 0; c < parts_[strip].chains.size(); ++c) {
        const Chain& chain = parts_[strip].chains[c];
        const std::size_t number = chains_.of(strip, c) + 1, n = left.ports.size();
        if (chain.start_side == side) starts[chain.start + (is_right ? 0 : n)] = number;
        if (chain.end_side == side) ends[chain.end + (is_right ? n : 0)] = number;
      }
    };
    note(i, kRight);
    note(i + 1, kLeft);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      ensure(starts[k] > 0 && ends[k] > 0, "a boundary goes on behind each port");
      cycles_.unite(starts[k] - 1, ends[k] - 1);
    }
  }

  void add_edges() {
    ends_.resize(pieces_.all());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t p = 0; p < parts_[i].pieces.size(); ++p) {
        const EdgePiece& piece = parts_[i].pieces[p];
        EdgePiece& whole = ends_[edges_.find(pieces_.of(i, p))];
        ensure(!(piece.has_tail && whole.has_tail) && !(piece.has_head && whole.has_head),
               "an edge has two ends");
        if (piece.has_tail) whole.has_tail = true, whole.tail = piece.tail;
        if (piece.has_head) whole.has_head = true, whole.head = piece.head;
      }
    }
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (edges_.find(e) != e) continue;
      ensure(ends_[e].has_tail && ends_[e].has_head, "an edge ends in vertices");
      totals_.signature += edge_hash(ends_[e].tail, ends_[e].head);
      ++totals_.edges;
    }
  }

  const EdgePiece& whole(std::size_t part, std::size_t piece) {
    return ends_[edges_.find(pieces_.of(part, piece))];
  }

  void add_corners() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (Corner corner : parts_[i].corners) {
        if (corner.before_piece != kNone) {
          const EdgePiece& edge = whole(i, corner.before_piece);
          corner.before = corner.before_reversed ? edge.head : edge.tail;
        }
        if (corner.behind_piece != kNone) {
          const EdgePiece& edge = whole(i, corner.behind_piece);
          corner.behind = corner.behind_reversed ? edge.tail : edge.head;
        }
        totals_.signature += corner_hash(corner.before, corner.vertex, corner.behind);
      }
    }
  }

  void add_components() {
    for (std::size_t c = 0; c < components_.all(); ++c) {
      if (whole_components_.find(c) == c) ++totals_.components;
    }
  }

  /// Per chain that stands for a cycle the sum of its halfedges.
  std::vector<CellHash> names_of_cycles() {
    std::vector<CellHash> sums(chains_.all());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t c = 0; c < parts_[i].chains.size(); ++c) {
        const Chain& chain = parts_[i].chains[c];
        CellHash& sum = sums[cycles_.find(chains_.of(i, c))];
        sum += chain.sum;
        if (chain.leaves == kNone) continue;
        const EdgePiece& edge = whole(i, chain.leaves);
        sum += chain.reversed ? halfedge_hash(edge.head, edge.tail)
                              : halfedge_hash(edge.tail, edge.head);
      }
    }
    return sums;
  }

  void add_faces(const std::vector<CellHash>& cycles) {
    const std::size_t unbounded = faces_.all();
    std::vector<CellHash> sums(faces_.all() + 1);
    std::vector<std::uint64_t> counts(faces_.all() + 1);
    for_each_face([&](std::size_t f, const OpenFace& face) {
      if (face.unbounded) whole_faces_.unite(f, unbounded);
    });
    for_each_face([&](std::size_t f, const OpenFace& face) {
      sums[whole_faces_.find(f)] += face.cycles;
      counts[whole_faces_.find(f)] += face.holes;
    });
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t c = 0; c < parts_[i].chains.size(); ++c) {
        const std::size_t chain = chains_.of(i, c);
        if (cycles_.find(chain) != chain) continue;
        const std::size_t face = whole_faces_.find(faces_.of(i, parts_[i].chains[c].face));
        sums[face] += cycle_hash(cycles[chain]);
        ++counts[face];
      }
    }
    for (std::size_t f = 0; f <= unbounded; ++f) {
      if (whole_faces_.find(f) != f) continue;
      const bool is_bounded = f != whole_faces_.find(unbounded);
      totals_.signature += face_hash(sums[f], is_bounded);
      ++totals_.faces;
      ensure(!is_bounded || counts[f] > 0, "a bounded face has an outer boundary");
      if (is_bounded) totals_.holes += counts[f] - 1;
    }
  }

  template <class Visit>
  void for_each_face(Visit visit) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t f = 0; f < parts_[i].faces.size(); ++f) {
        visit(faces_.of(i, f), parts_[i].faces[f]);
      }
    }
  }

  std::span<const StripPart> parts_;
  Offsets pieces_, components_, chains_, faces_;
  UnionFind edges_, whole_components_, cycles_, whole_faces_;
  std::vector<EdgePiece> ends_;  ///< of the piece that stands for an edge
  Totals totals_;
};

}  // namespace

Totals merged(std::span<const StripPart> parts) { return Merging(parts).run(); }

}  // namespace plumbline::tiles
