// A loose chain leads from a loose end over vertices of two edges to a junction. Its reach is the
// largest distance of its vertices from there. Chains go in the order of their reach, those of the
// same reach together, since one that goes can make others longer: so a tree of them loses its
// twigs, and not its stem.

#include <algorithm>
#include <map>
#include <set>

#include "repair/cut.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// The graph of a complex from which edges go.
class Graph {
 public:
  explicit Graph(const ExactComplex& complex) : complex_(complex), edges_(complex.vertices.size()) {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      edges_[complex.edges[e].tail].emplace_back(e);
      edges_[complex.edges[e].head].emplace_back(e);
    }
  }

  std::size_t degree(VertexId v) const { return edges_[v].size(); }
  VertexId other_end(EdgeId e, VertexId v) const {
    const Edge& edge = complex_.edges[e];
    return edge.tail == v ? edge.head : edge.tail;
  }
  /// From a loose end to the first vertex that is not of two edges.
  std::vector<EdgeId> chain(VertexId tip) const {
    std::vector<EdgeId> result = {edges_[tip].front()};
    VertexId v = other_end(result.front(), tip);
    while (degree(v) == 2) {
      result.push_back(edges_[v][edges_[v][0] == result.back() ? 1 : 0]);
      v = other_end(result.back(), v);
    }
    return result;
  }
  /// Where the way from v along e ends: at the first vertex that is not of two edges, or at v.
  VertexId end_of_way(VertexId v, EdgeId e) const {
    VertexId w = other_end(e, v);
    while (degree(w) == 2 && w != v) {
      e = edges_[w][edges_[w][0] == e ? 1 : 0];
      w = other_end(e, w);
    }
    return w;
  }
  const std::vector<EdgeId>& edges(VertexId v) const { return edges_[v]; }
  void remove(EdgeId e) {
    std::erase(edges_[complex_.edges[e].tail], e);
    std::erase(edges_[complex_.edges[e].head], e);
  }

 private:
  const ExactComplex& complex_;
  std::vector<std::vector<EdgeId>> edges_;
};

struct Loose {
  VertexId tip, junction;
  std::vector<EdgeId> edges;  ///< from the tip on
};

class Trimming {
 public:
  Trimming(Work& work, const Arranged& arranged, const Rational& reach)
      : work_(work),
        arranged_(arranged),
        complex_(arranged.complex),
        graph_(arranged.complex),
        squared_reach_(reach * reach) {}

  void run() {
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
      if (graph_.degree(VertexId(v)) == 1) add(VertexId(v));
    }
    while (!by_reach_.empty()) {
      const Rational reach = by_reach_.begin()->first;
      std::map<VertexId, std::vector<Loose>> at;  // by junction
      for (const VertexId tip : by_reach_.begin()->second) {
        Loose loose = loose_at(tip);
        at[loose.junction].push_back(std::move(loose));
        reach_of_.erase(tip);
      }
      by_reach_.erase(by_reach_.begin());
      for (const auto& [junction, chains] : at) {
        // A star of equal chains alone: none is the one to go.
        if (chains.size() == graph_.degree(junction)) continue;
        for (const Loose& loose : chains) remove(loose, reach);
      }
      for (const auto& [junction, chains] : at) update(junction);
    }
  }

  LooseReaches reaches() const {
    LooseReaches result;
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
      if (graph_.degree(VertexId(v)) != 1) continue;
      const Loose loose = loose_at(VertexId(v));
      const std::optional<Rational> reach = squared_reach(loose);
      if (reach) (is_past(loose) ? result.past : result.others).push_back(*reach);
    }
    return result;
  }

 private:
  Loose loose_at(VertexId tip) const {
    std::vector<EdgeId> edges = graph_.chain(tip);
    VertexId v = tip;
    for (const EdgeId e : edges) v = graph_.other_end(e, v);
    return {tip, v, std::move(edges)};
  }

  /// The squared reach of a chain; none for a free piece, what is anchored, and beyond the limit.
  std::optional<Rational> squared_reach(const Loose& loose) const {
    if (graph_.degree(loose.junction) < 3) return std::nullopt;
    const Point junction = complex_.vertices[loose.junction];
    Rational reach = 0;
    VertexId v = loose.tip;
    for (const EdgeId e : loose.edges) {
      reach = std::max(reach, squared_distance(complex_.vertices[v], junction));
      if (reach > squared_reach_) return std::nullopt;
      v = graph_.other_end(e, v);
    }
    if (is_fixed(work_, arranged_, loose.edges)) return std::nullopt;
    return reach;
  }

  /// Puts the chain of a tip where its reach is.
  void add(VertexId tip) {
    std::optional<Rational> reach = squared_reach(loose_at(tip));
    if (!reach) return;
    by_reach_[*reach].insert(tip);
    reach_of_[tip] = std::move(*reach);
  }

  /// Whether one of the chain's lines goes on beyond its junction.
  bool is_past(const Loose& loose) const {
    const Point junction = complex_.vertices[loose.junction];
    return std::ranges::any_of(arranged_.lines(loose.edges.back()), [&](LineId id) {
      const Line line = work_.line(id);
      return line.a != junction && line.b != junction;
    });
  }

  /// A junction that has lost edges: what ended there may lead on, or end now.
  void update(VertexId junction) {
    if (graph_.degree(junction) == 1) return add(junction);
    if (graph_.degree(junction) != 2) return;
    const std::vector<EdgeId> ways = graph_.edges(junction);
    for (const EdgeId e : ways) {
      const VertexId end = graph_.end_of_way(junction, e);
      if (graph_.degree(end) != 1) continue;
      if (const auto known = reach_of_.find(end); known != reach_of_.end()) {
        std::set<VertexId>& tips = by_reach_[known->second];
        tips.erase(end);
        if (tips.empty()) by_reach_.erase(known->second);
        reach_of_.erase(known);
      }
      add(end);
    }
  }

  void remove(const Loose& loose, const Rational& squared_size) {
    for (const EdgeId e : loose.edges) graph_.remove(e);
    cut(work_, arranged_, loose.edges, EditKind::Trim, complex_.vertices[loose.junction],
        squared_size);
  }

  Work& work_;
  const Arranged& arranged_;
  const ExactComplex& complex_;
  Graph graph_;
  Rational squared_reach_;
  std::map<Rational, std::set<VertexId>> by_reach_;
  std::map<VertexId, Rational> reach_of_;
};

}  // namespace

LooseReaches loose_reaches(Work& work, const Arranged& arranged, const Rational& most) {
  return Trimming(work, arranged, most).reaches();
}

void trim(Work& work, const Arranged& arranged, const Rational& reach) {
  Trimming(work, arranged, reach).run();
}

}  // namespace plumbline::repair_steps
