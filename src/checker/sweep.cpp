// Step 3: a sweep over the vertices in their lexicographic order, which is that of a vertical line
// leaning to the left by less than anything. Its status are the edges that the line crosses, from
// the lowest to the highest.
//
// Why it is enough to look at vertices. Say that two edges that were in their true order meet,
// first of all, at q, which is not a common vertex. If q is a vertex, all edges through q are next
// to each other in the status, which is right up to here, so one that does not end there is found
// next to q: refused. If it is not, two of them, a below b, are neighbours in the status from then
// on although b is below a. The next time that something is done to one of them or between them, at
// a vertex v, either v is found on or between them, which means above a and below b, or v is the
// head of one of them and the other its neighbour on the side where it is not (they cannot both end
// there: lines meet once). Refused, and it must happen, since every edge ends.
//
// After q the status may be out of order. A search in it then finds an arbitrary place, but it
// ends, and insertions, which compare with the two neighbours just proved right, go where they are
// told to.

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "steps.hpp"

namespace plumbline_checker {
namespace {

class PlaneSweep {
 public:
  PlaneSweep(const Input& input, const Certificate& certificate)
      : input_(input),
        certificate_(certificate),
        status_(Below{*this}),
        place_(certificate.edges.size()) {
    result_.next.assign(2 * certificate.edges.size(), kNone);
    result_.topmost.assign(certificate.vertices.size(), kNone);
    result_.below.assign(certificate.vertices.size(), kNone);
    ending_.assign(certificate.vertices.size(), Ending{});
    for (Index e = 0; e < certificate.edges.size(); ++e) {
      Ending& ending = ending_[certificate.edges[e].head];
      ++ending.count;
      ending.edge = e;
    }
  }

  Sweep run() {
    for (Index v = 0; v < certificate_.vertices.size(); ++v) pass(v);
    return std::move(result_);
  }

 private:
  /// The order of the status: edges among themselves, and a point between them.
  struct Below {
    using is_transparent = void;
    const PlaneSweep& sweep;
    bool operator()(Index a, Index b) const { return sweep.is_below(a, b); }
    bool operator()(Index edge, const Point& p) const { return side(sweep.line(edge), p) > 0; }
    bool operator()(const Point& p, Index edge) const { return side(sweep.line(edge), p) < 0; }
  };
  using Status = std::set<Index, Below>;
  using Place = Status::const_iterator;

  /// Edges that end at a vertex.
  struct Ending {
    Index count = 0;
    Index edge = kNone;  ///< one of them
  };

  /// Edges lie on their segments, and point the same way: this was checked before.
  const Line& line(Index edge) const {
    return input_.segments[*certificate_.segments.begin(edge)].line;
  }
  const Edge& edge(Index e) const { return certificate_.edges[e]; }

  bool is_below(Index a, Index b) const {
    if (edge(a).tail == edge(b).tail) return turn(line(a), line(b)) > 0;
    if (edge(a).tail < edge(b).tail) return side(line(a), certificate_.vertices[edge(b).tail]) > 0;
    return side(line(b), certificate_.vertices[edge(a).tail]) < 0;
  }

  void pass(Index v) {
    around_.clear();
    const Point& p = certificate_.vertices[v];
    Place above = ending_[v].count > 0 ? end_edges(v) : status_.lower_bound(p);
    if (above != status_.end() && side(line(*above), p) >= 0) refuse(v, *above, "below");
    const bool has_below = above != status_.begin();
    const Index below = has_below ? *std::prev(above) : kNone;
    if (has_below && side(line(below), p) <= 0) refuse(v, below, "above");
    if (ending_[v].count == 0) result_.below[v] = below;
    start_edges(v, above);
    turn_around();
  }

  /// Takes the edges that end at a vertex out of the status, the highest first, and returns the
  /// place that they leave.
  Place end_edges(Index v) {
    Place last = place_[ending_[v].edge];
    while (std::next(last) != status_.end() && edge(*std::next(last)).head == v) ++last;
    ++last;
    for (Index count = 0; count < ending_[v].count; ++count) {
      if (last == status_.begin() || edge(*std::prev(last)).head != v) {
        certificate_.refuse_vertex(v, "is an end of edges between which another one passes");
      }
      const Place ended = std::prev(last);
      ending_edges_.push_back(*ended);
      last = status_.erase(ended);
    }
    return last;
  }

  /// Puts the edges that start at a vertex into the status, below a place.
  void start_edges(Index v, Place above) {
    for (; next_edge_ < certificate_.edges.size() && edge(next_edge_).tail == v; ++next_edge_) {
      around_.push_back(next_edge_);
    }
    // All point to the right or straight up, so that turns order them.
    std::sort(around_.begin(), around_.end(),
              [&](Index a, Index b) { return turn(line(a), line(b)) > 0; });
    for (std::size_t i = 0; i < around_.size(); ++i) {
      if (i > 0 && turn(line(around_[i - 1]), line(around_[i])) <= 0) {
        certificate_.refuse_edge(
            around_[i],
            "leaves its tail in the direction of edge " + std::to_string(around_[i - 1]),
            certificate_.vertices[v]);
      }
      place_[around_[i]] = status_.insert(above, around_[i]);
    }
    if (!around_.empty()) result_.topmost[v] = around_.back();
  }

  /// `around_` has the edges to the right from the lowest to the highest: with those to the left
  /// from the highest to the lowest they are in counter-clockwise order.
  void turn_around() {
    for (Index& e : around_) e = along(e);
    for (const Index e : ending_edges_) around_.push_back(against(e));
    ending_edges_.clear();
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const Index arriving = around_[i] ^ 1;
      result_.next[arriving] = around_[(i > 0 ? i : around_.size()) - 1];
    }
  }

  [[noreturn]] void refuse(Index v, Index e, const char* where) const {
    const std::string edge = " edge " + std::to_string(e);
    certificate_.refuse_vertex(
        v, side(line(e), certificate_.vertices[v]) == 0
               ? "lies on" + edge
               : std::string("is not ") + where + edge + ", so that edges cross to the left of it");
  }

  const Input& input_;
  const Certificate& certificate_;
  Status status_;
  std::vector<Place> place_;  ///< of each edge in the status
  std::vector<Ending> ending_;
  std::vector<Index> around_;        ///< of the vertex at hand: edges, then halfedges
  std::vector<Index> ending_edges_;  ///< there, from the highest to the lowest
  Index next_edge_ = 0;
  Sweep result_;
};

}  // namespace

Sweep check_planarity(const Input& input, const Certificate& certificate) {
  return PlaneSweep(input, certificate).run();
}

}  // namespace plumbline_checker
