// On several threads, each walks the pieces of cycles within its block of halfedges; pieces are
// then joined. As numbering follows the plane, few pieces leave a block.

#include "arrange/bucket/cycles.hpp"

#include <algorithm>

namespace plumbline::bucket {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 15U;

/// A maximal walk inside a block, or a whole cycle.
struct Piece {
  HalfedgeId least;
  HalfedgeId exit;  ///< the first halfedge behind it; none for a whole cycle
};

Cycles walk_serially(const std::vector<HalfedgeId>& next) {
  Cycles cycles;
  cycles.of_halfedge.resize(next.size());
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (cycles.of_halfedge[start].valid()) continue;
    const CycleId id(cycles.first.size());
    cycles.first.emplace_back(start);
    for (HalfedgeId h(start); !cycles.of_halfedge[h].valid(); h = next[h]) {
      cycles.of_halfedge[h] = id;
    }
  }
  return cycles;
}

class ParallelWalk {
 public:
  ParallelWalk(const std::vector<HalfedgeId>& next, Job& job)
      : next_(next),
        job_(job),
        mark_(next.size(), 0),
        piece_(next.size()),
        pieces_((next.size() + kBlock - 1) / kBlock) {}

  Cycles walk() {
    job_.for_each(next_.size(), [&](std::size_t h) {
      if (next_[h] / kBlock != h / kBlock) mark_[next_[h]] = 1;
    });
    job_.for_blocks(next_.size(), kBlock,
                    [&](std::size_t begin, std::size_t end) { walk_block(begin, end); });
    return join();
  }

 private:
  /// Walks the pieces that start at entries (marked), then the cycles that never leave.
  void walk_block(std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      if (mark_[h] != 0) walk_piece(HalfedgeId(h), begin / kBlock);
    }
    for (std::size_t h = begin; h < end; ++h) {
      if (!piece_[h].valid()) walk_piece(HalfedgeId(h), begin / kBlock);
    }
  }

  void walk_piece(HalfedgeId h, std::size_t block) {
    const CycleId id(pieces_[block].size());
    Piece piece{h, {}};
    while (h / kBlock == block && !piece_[h].valid()) {
      piece_[h] = id;
      piece.least = std::min(piece.least, h);
      h = next_[h];
    }
    if (h / kBlock != block) piece.exit = h;
    pieces_[block].push_back(piece);
  }

  Cycles join() {
    std::vector<std::uint32_t> offset;
    for (const auto& block : pieces_) offset.push_back(static_cast<std::uint32_t>(block.size()));
    accumulate(offset);
    const auto number = [&](HalfedgeId h) { return offset[h / kBlock] + piece_[h]; };
    // Per piece, the least halfedge of its cycle; marked.
    std::vector<HalfedgeId> least(offset.back());
    std::fill(mark_.begin(), mark_.end(), 0);
    std::vector<std::size_t> members;
    for (std::size_t b = 0; b < pieces_.size(); ++b) {
      for (std::size_t i = 0; i < pieces_[b].size(); ++i) {
        if (least[offset[b] + i].valid()) continue;
        members.assign(1, offset[b] + i);
        Piece piece = pieces_[b][i];
        HalfedgeId first = piece.least;
        while (piece.exit.valid() && number(piece.exit) != members.front()) {
          members.push_back(number(piece.exit));
          piece = pieces_[piece.exit / kBlock][piece_[piece.exit]];
          first = std::min(first, piece.least);
        }
        for (const std::size_t m : members) least[m] = first;
        mark_[first] = 1;
      }
    }
    Cycles cycles;
    std::vector<CycleId> cycle_of(least.size());
    for (std::size_t h = 0; h < mark_.size(); ++h) {
      if (mark_[h] == 0) continue;
      cycle_of[number(HalfedgeId(h))] = CycleId(cycles.first.size());
      cycles.first.emplace_back(h);
    }
    for (std::size_t p = 0; p < least.size(); ++p) cycle_of[p] = cycle_of[number(least[p])];
    job_.for_each(next_.size(),
                  [&](std::size_t h) { piece_[h] = cycle_of[number(HalfedgeId(h))]; });
    cycles.of_halfedge = std::move(piece_);
    return cycles;
  }

  const std::vector<HalfedgeId>& next_;
  Job& job_;
  std::vector<std::uint8_t> mark_;
  std::vector<CycleId> piece_;  ///< per halfedge, counted in its block
  std::vector<std::vector<Piece>> pieces_;
};

}  // namespace

Cycles walk_cycles(const std::vector<HalfedgeId>& next, Job& job) {
  if (!job.is_parallel() || next.size() <= kBlock) return walk_serially(next);
  return ParallelWalk(next, job).walk();
}

}  // namespace plumbline::bucket
