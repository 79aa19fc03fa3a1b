// Matches edges by their ends and says what became of the others.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compare/chain.hpp"
#include "compare/steps.hpp"

namespace plumbline::compare_steps {
namespace {

using Walk = std::vector<HalfedgeId>;

/// An edge without a match whose ends both have an image, and these images.
struct OpenEdge {
  Side side;
  EdgeId edge;
  VertexId from, to;
};

class EdgeMatcher {
 public:
  EdgeMatcher(const Sides& sides, const VertexMatch& vertices, std::size_t first_number,
              Detail detail)
      : sides_(sides), vertices_(vertices), first_number_(first_number), detail_(detail) {
    for (const Side side : kBothSides) {
      result_.match[side].resize(sides[side].edge_count());
      result_.number[side].resize(sides[side].edge_count());
      result_.along[side].resize(sides[side].edge_count());
    }
  }

  EdgeMatch run() {
    match_by_ends(Exact, vertices_.match);
    match_by_ends(Exact, vertices_.image);
    match_by_ends(Float, vertices_.image);
    for (const Side side : kBothSides) {
      report_collapsed(side);
      report_parallel(side);
    }
    for (const Side side : kBothSides) report_chains(side, unaccounted(other(side)), false);
    for (const Side side : kBothSides) {
      report_chains(side, std::vector<bool>(sides_[other(side)].edge_count(), true), true);
    }
    for (const Side side : kBothSides) report_lacking(side);
    return std::move(result_);
  }

 private:
  void match_by_ends(Side side, const Both<std::vector<VertexId>>& ends_of);
  void report_collapsed(Side side);
  void report_parallel(Side side);
  void report_chains(Side side, const std::vector<bool>& is_usable, bool edges_are_matched);
  void report_lacking(Side side);

  bool is_accounted(Side side, EdgeId e) const {
    return result_.match[side][e].valid() || result_.number[side][e] != 0;
  }
  std::vector<bool> unaccounted(Side side) const;
  /// The edges not accounted for whose ends both have an image, ascending.
  std::vector<OpenEdge> open_edges(Side side) const;
  void add(Finding finding);
  Finding finding(Side side, Disagreement disagreement, const std::vector<EdgeId>& here,
                  const std::vector<EdgeId>& there, std::string message) const;
  void measure_collapsed(Finding& finding, Side side, const std::vector<EdgeId>& edges,
                         VertexId v) const;
  void set_image(const OpenEdge& open, const Walk& chain);
  Numbers why_lacking(Side side, EdgeId e) const;

  const Sides& sides_;
  const VertexMatch& vertices_;
  const std::size_t first_number_;
  const Detail detail_;
  std::size_t chain_steps_ =
      kLeastSteps + kStepsPerEdge * (sides_[Exact].edge_count() + sides_[Float].edge_count());
  EdgeMatch result_;
};

void EdgeMatcher::match_by_ends(Side side, const Both<std::vector<VertexId>>& ends_of) {
  for (std::size_t i = 0; i < sides_[side].edge_count(); ++i) {
    const EdgeId e(i);
    const Edge& edge = sides_[side].edges[e];
    const VertexId from = ends_of[side][edge.tail], to = ends_of[side][edge.head];
    if (result_.match[side][e].valid() || !from.valid() || !to.valid() || from == to) continue;
    const EdgeId f = edge_between(sides_, other(side), from, to);
    if (!f.valid() || result_.match[other(side)][f].valid()) continue;
    result_.match[side][e] = f;
    result_.match[other(side)][f] = e;
    const bool is_reversed = sides_[other(side)].edges[f].tail != from;
    result_.along[side][e] = halfedge(f, is_reversed);
    result_.along[other(side)][f] = halfedge(e, is_reversed);
  }
}

std::vector<bool> EdgeMatcher::unaccounted(Side side) const {
  std::vector<bool> result(sides_[side].edge_count());
  for (std::size_t e = 0; e < result.size(); ++e) result[e] = !is_accounted(side, EdgeId(e));
  return result;
}

std::vector<OpenEdge> EdgeMatcher::open_edges(Side side) const {
  std::vector<OpenEdge> result;
  for (std::size_t i = 0; i < sides_[side].edge_count(); ++i) {
    const EdgeId e(i);
    const Edge& edge = sides_[side].edges[e];
    const OpenEdge open{side, e, vertices_.image[side][edge.tail],
                        vertices_.image[side][edge.head]};
    if (!is_accounted(side, e) && open.from.valid() && open.to.valid()) result.push_back(open);
  }
  return result;
}

void EdgeMatcher::add(Finding finding) {
  for (const Side side : kBothSides) {
    for (const std::size_t e : cells(finding, side)) {
      if (result_.number[side][e] == 0) {
        result_.number[side][e] = first_number_ + result_.findings.size();
      }
    }
  }
  result_.findings.push_back(std::move(finding));
}

Finding EdgeMatcher::finding(Side side, Disagreement disagreement, const std::vector<EdgeId>& here,
                             const std::vector<EdgeId>& there, std::string message) const {
  Finding result;
  result.kind = CellKind::Edge;
  result.disagreement = disagreement;
  result.message = std::move(message);
  if (detail_ == Detail::Full) result.where = midpoint(sides_[side], here.back());
  cells(result, side).assign(here.begin(), here.end());
  cells(result, other(side)).assign(there.begin(), there.end());
  for (const Side s : kBothSides) std::sort(cells(result, s).begin(), cells(result, s).end());
  result.segments =
      joined(segments_of(sides_[side], here), segments_of(sides_[other(side)], there));
  return result;
}

/// Adds to a finding how long the edges are that are vertex v of the other side.
void EdgeMatcher::measure_collapsed(Finding& finding, Side side, const std::vector<EdgeId>& edges,
                                    VertexId v) const {
  Rational longest = 0;
  for (const EdgeId e : edges) {
    const Edge& edge = sides_[side].edges[e];
    longest = std::max(
        longest, squared_distance(sides_.point(side, edge.tail), sides_.point(side, edge.head)));
  }
  finding.where = sides_.point(other(side), v);
  finding.squared_distance = longest;
  finding.distance = length(longest);
  finding.message =
      fmt::format("{} no longer than {} {} one {} vertex",
                  counted(edges.size(), fmt::format("one {} edge", name(side)),
                          fmt::format("{} edges", name(side))),
                  rough(*finding.distance), side == Exact ? "collapsed into" : "grew out of",
                  name(other(side)));
}

/// Edges whose two ends are one vertex of the other side: one finding for each such vertex.
void EdgeMatcher::report_collapsed(Side side) {
  std::map<VertexId, std::vector<EdgeId>> by_vertex;
  for (const OpenEdge& open : open_edges(side)) {
    if (open.from == open.to) by_vertex[open.from].push_back(open.edge);
  }
  for (const auto& [v, edges] : by_vertex) {
    for (const EdgeId e : edges) result_.other_image[side][e] = {};
    Finding f = finding(side, joining(side), edges, {}, {});
    if (detail_ == Detail::Full) measure_collapsed(f, side, edges, v);
    f.segments = joined(std::move(f.segments), segments_at(sides_, other(side), std::array{v}));
    add(std::move(f));
  }
}

/// Edges that join the same vertices of the other side: one finding for each edge there.
void EdgeMatcher::report_parallel(Side side) {
  std::map<EdgeId, std::vector<EdgeId>> by_edge;
  for (const OpenEdge& open : open_edges(side)) {
    const EdgeId f = edge_between(sides_, other(side), open.from, open.to);
    if (!f.valid()) continue;
    by_edge[f].push_back(open.edge);
    result_.other_image[side][open.edge] =
        Walk{halfedge(f, sides_[other(side)].edges[f].tail != open.from)};
  }
  for (auto& [f, edges] : by_edge) {
    if (const EdgeId match = result_.match[other(side)][f]; match.valid()) {
      edges.insert(edges.begin(), match);
    }
    const std::string message =
        side == Exact
            ? fmt::format("{} exact edges became one float edge", edges.size())
            : fmt::format("one exact edge became {} float edges side by side", edges.size());
    add(finding(side, joining(side), edges, {f}, message));
  }
}

/// The edge is the whole chain; of the chain, the first edge stands for it and the others for
/// nothing.
void EdgeMatcher::set_image(const OpenEdge& open, const Walk& chain) {
  result_.other_image[open.side][open.edge] = chain;
  for (const HalfedgeId h : chain) {
    if (result_.image(other(open.side), edge_of(h))) continue;
    Walk& image = result_.other_image[other(open.side)][edge_of(h)];
    if (h == chain.front()) image.push_back(halfedge(open.edge, is_reversed(h)));
  }
}

/// Edges that lie along a chain of edges of the other side.
void EdgeMatcher::report_chains(Side side, const std::vector<bool>& is_usable,
                                bool edges_are_matched) {
  std::vector<bool> usable = is_usable;
  for (const OpenEdge& open : open_edges(side)) {
    const Edge& edge = sides_[side].edges[open.edge];
    const Segment ab{sides_.point(side, edge.tail), sides_.point(side, edge.head)};
    const Walk chain = open.from == open.to ? Walk{}
                                            : chain_along(sides_, other(side), open.from, open.to,
                                                          ab, usable, chain_steps_);
    if (chain.empty()) continue;
    std::vector<EdgeId> here{open.edge}, there;
    Rational farthest = 0;
    for (const HalfedgeId h : chain) {
      const EdgeId f = edge_of(h);
      there.push_back(f);
      if (!edges_are_matched) usable[f] = false;
      if (result_.match[other(side)][f].valid()) here.push_back(result_.match[other(side)][f]);
      if (detail_ != Detail::Full) continue;
      const Point& p = sides_.point(other(side), sides_[other(side)].target(h));
      farthest = std::max(farthest, squared_distance(p, ab.a, ab.b));
    }
    std::rotate(here.begin(), here.begin() + 1, here.end());  // the place is that of the last
    const std::string message =
        edges_are_matched
            ? fmt::format("one {} edge runs along {} {} edges that correspond to others",
                          name(side), there.size(), name(other(side)))
        : side == Exact
            ? fmt::format("one exact edge became a chain of {} float edges", there.size())
            : fmt::format("a chain of {} exact edges became one float edge", there.size());
    const Side joined_side = edges_are_matched ? side : other(side);
    Finding f = finding(side, joining(joined_side), here, there, message);
    f.squared_distance = farthest;
    f.distance = length(farthest);
    set_image(open, chain);
    add(std::move(f));
  }
}

Numbers EdgeMatcher::why_lacking(Side side, EdgeId e) const {
  const Edge& edge = sides_[side].edges[e];
  Numbers numbers;
  for (const VertexId v : {edge.tail, edge.head}) {
    if (!vertices_.image[side][v].valid()) numbers.push_back(vertices_.number[side][v]);
  }
  return numbers;
}

void EdgeMatcher::report_lacking(Side side) {
  const char* message = side == Exact ? "an exact edge is missing from the float result"
                                      : "a float edge has no exact counterpart";
  for (std::size_t i = 0; i < sides_[side].edge_count(); ++i) {
    if (const EdgeId e(i); !is_accounted(side, e)) {
      Finding f = finding(side, lacking(side), {e}, {}, message);
      add_causes(f, why_lacking(side, e));
      add(std::move(f));
    }
  }
}

}  // namespace

std::optional<std::span<const HalfedgeId>> EdgeMatch::image(Side side, EdgeId e) const {
  if (along[side][e].valid()) return std::span(&along[side][e], 1);
  const auto found = other_image[side].find(e);
  if (found == other_image[side].end()) return std::nullopt;
  return std::span<const HalfedgeId>(found->second);
}

EdgeMatch match_edges(const Sides& sides, const VertexMatch& vertices, std::size_t first_number,
                      Detail detail) {
  return EdgeMatcher(sides, vertices, first_number, detail).run();
}

}  // namespace plumbline::compare_steps
