// Compares holes and isolated vertices of corresponding faces, and thereby the nesting.

#include <fmt/format.h>

#include <algorithm>

#include "compare/steps.hpp"

namespace plumbline::compare_steps {
namespace {

class NestingCheck {
 public:
  NestingCheck(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
               const CycleMatch& cycles, const FaceMatch& faces)
      : sides_(sides), vertices_(vertices), edges_(edges), cycles_(cycles), faces_(faces) {
    holes_ = {holes(Exact), holes(Float)};
  }

  std::vector<Finding> run() {
    for (const Group& group : connected_groups(holes_, shared_edges())) check(group);
    check_isolated_vertices();
    return std::move(findings_);
  }

 private:
  bool is_undisturbed(Side side, CycleId c) const;
  std::vector<std::size_t> holes(Side side) const;
  std::vector<std::pair<std::size_t, std::size_t>> shared_edges() const;
  void check(const Group& group);
  void check_isolated_vertices();
  void add(const Group& group, Disagreement disagreement, std::string message);

  std::size_t group_of_parent(Side side, std::size_t cycle) const {
    const FaceId f = sides_[side].cycle_face[cycle];
    return f.valid() ? faces_.group[side][f] : kNoGroup;
  }
  /// Whether a missing or extra hole has a finding of its own: that of an unbounded face is the
  /// outline of a component whose cells are reported, that of a missing face goes with it.
  bool is_of_interest(Side side, std::size_t cycle) const {
    const std::size_t group = group_of_parent(side, cycle);
    return group != kNoGroup && group != faces_.group[side][kUnbounded];
  }
  std::string face_text(Side side, FaceId f) const;
  Numbers causes(const Group& group) const;

  const Sides& sides_;
  const VertexMatch& vertices_;
  const EdgeMatch& edges_;
  const CycleMatch& cycles_;
  const FaceMatch& faces_;
  Both<std::vector<std::size_t>> holes_;  ///< disturbed ones, ascending
  std::vector<Finding> findings_;
};

std::vector<std::size_t> NestingCheck::holes(Side side) const {
  std::vector<std::size_t> result;
  for (const CycleId c : sides_[side].face_holes.flat()) {
    if (!is_undisturbed(side, c)) result.push_back(c);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Whether the hole is the same on both sides, in faces that correspond: nothing to say about it.
bool NestingCheck::is_undisturbed(Side side, CycleId c) const {
  const CycleId there = cycles_.same[side][c];
  if (!there.valid() || cycles_.same[other(side)][there] != c) return false;
  if (!cycles_.is_one_to_one[side == Exact ? c : there]) return false;
  const std::size_t group = group_of_parent(side, c);
  return group != kNoGroup && group == group_of_parent(other(side), there);
}

/// Pairs of holes, an exact and a float one, that have an edge in common.
std::vector<std::pair<std::size_t, std::size_t>> NestingCheck::shared_edges() const {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const Side side : kBothSides) {
    const std::vector<std::size_t>& others = holes_[other(side)];
    for (const std::size_t c : holes_[side]) {
      for (const HalfedgeId h : sides_[side].cycles[c]) {
        const auto image = edges_.image(side, edge_of(h));
        if (!image) continue;
        for (const HalfedgeId t : *image) {
          const CycleId d = cycles_.cycle_of[other(side)][is_reversed(h) ? twin(t) : t];
          if (!d.valid() || !std::binary_search(others.begin(), others.end(), d)) continue;
          if (side == Exact) result.emplace_back(c, d);
          if (side == Float) result.emplace_back(d, c);
        }
      }
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::string NestingCheck::face_text(Side side, FaceId f) const {
  if (f == kUnbounded) return fmt::format("the unbounded {} face", name(side));
  return fmt::format("{} face {}, depth {}", name(side), static_cast<std::size_t>(f),
                     sides_[side].face_depth[f]);
}

Numbers NestingCheck::causes(const Group& group) const {
  Numbers result;
  for (const Side side : kBothSides) {
    for (const std::size_t c : group[side]) {
      for (const HalfedgeId h : sides_[side].cycles[c]) {
        result.push_back(edges_.number[side][edge_of(h)]);
      }
    }
  }
  return result;
}

void NestingCheck::add(const Group& group, Disagreement disagreement, std::string message) {
  Finding finding;
  finding.kind = CellKind::Hole;
  finding.disagreement = disagreement;
  finding.message = std::move(message);
  add_causes(finding, causes(group));
  for (const Side side : kBothSides) {
    cells(finding, side) = group[side];
    std::vector<EdgeId> edges;
    for (const std::size_t c : group[side]) {
      for (const HalfedgeId h : sides_[side].cycles[c]) edges.push_back(edge_of(h));
    }
    finding.segments = joined(std::move(finding.segments), segments_of(sides_[side], edges));
  }
  const Side side = group[Exact].empty() ? Float : Exact;
  finding.where = sides_.point(side, sides_[side].origin(sides_[side].cycles[group[side][0]][0]));
  findings_.push_back(std::move(finding));
}

void NestingCheck::check(const Group& group) {
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  if (m == 1 && n == 1) {
    const std::size_t c = group[Exact][0], d = group[Float][0];
    const std::size_t exact_group = group_of_parent(Exact, c);
    const std::size_t float_group = group_of_parent(Float, d);
    if (exact_group != kNoGroup && float_group != kNoGroup && exact_group != float_group) {
      add(group, Disagreement::WrongParent,
          fmt::format("a component lies in {} and not in {}",
                      face_text(Float, sides_[Float].cycle_face[d]),
                      face_text(Exact, sides_[Exact].cycle_face[c])));
      return;
    }
    if (cycles_.is_one_to_one[c] && cycles_.same[Exact][c] == CycleId(d)) return;
  }
  const auto is_of_interest_in = [&](Side side) {
    return std::any_of(group[side].begin(), group[side].end(),
                       [&](std::size_t c) { return is_of_interest(side, c); });
  };
  if (!is_of_interest_in(Exact) && !is_of_interest_in(Float)) return;
  if (n == 0) return add(group, Disagreement::Missing, "a hole is missing from the float result");
  if (m == 0) return add(group, Disagreement::Extra, "a float hole has no exact counterpart");
  if (m == n) return add(group, Disagreement::Reshaped, "a hole has other edges on its boundary");
  add(group, m > n ? Disagreement::Merged : Disagreement::Split,
      fmt::format("{} became {}", counted(m, "one exact hole", "exact holes"),
                  counted(n, "one float hole", "float holes")));
}

void NestingCheck::check_isolated_vertices() {
  std::vector<FaceId> float_face(sides_[Float].vertices.size());
  for (std::size_t g = 0; g < sides_[Float].face_count(); ++g) {
    for (const VertexId w : sides_[Float].face_isolated_vertices[g]) float_face[w] = FaceId(g);
  }
  for (std::size_t f = 0; f < sides_[Exact].face_count(); ++f) {
    for (const VertexId v : sides_[Exact].face_isolated_vertices[f]) {
      const VertexId w = vertices_.match[Exact][v];
      if (!w.valid() || !float_face[w].valid()) continue;
      const std::size_t float_group = faces_.group[Float][float_face[w]];
      if (float_group == kNoGroup || faces_.group[Exact][f] == kNoGroup) continue;
      if (float_group == faces_.group[Exact][f]) continue;
      Finding finding;
      finding.kind = CellKind::Vertex;
      finding.disagreement = Disagreement::WrongParent;
      finding.message = fmt::format("an isolated vertex lies in {} and not in {}",
                                    face_text(Float, float_face[w]), face_text(Exact, FaceId(f)));
      finding.where = sides_.point(Exact, v);
      finding.exact_cells = {v};
      finding.float_cells = {w};
      findings_.push_back(std::move(finding));
    }
  }
}

}  // namespace

std::vector<Finding> nesting(const Sides& sides, const VertexMatch& vertices,
                             const EdgeMatch& edges, const CycleMatch& cycles,
                             const FaceMatch& faces) {
  return NestingCheck(sides, vertices, edges, cycles, faces).run();
}

}  // namespace plumbline::compare_steps
