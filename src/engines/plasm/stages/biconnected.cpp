// Hopcroft and Tarjan without recursion, in the original's order: vertices and edges ascending.

#include <algorithm>

#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

class Search {
 public:
  explicit Search(const Graph& graph)
      : graph_(graph),
        edges_at_(graph.vertices.size()),
        number_(graph.vertices.size(), 0),
        is_walked_(graph.edges.size(), false) {
    for (std::size_t e = graph.edges.size(); e-- > 0;) {
      for (const VertexId v : graph.edges[e]) edges_at_[v].emplace_back(e);
    }
  }

  /// The components that can be reached from here.
  void from(VertexId root) {
    if (number_[root] != 0) return;
    enter(root, 1);
    while (!path_.empty()) {
      const EdgeId edge = unwalked(path_.back().vertex);
      if (edge.valid()) {
        walk(edge);
      } else {
        leave();
      }
    }
  }

  std::vector<std::vector<EdgeId>> components;

 private:
  struct Step {
    VertexId vertex;
    std::size_t lowest = 0;  ///< the least number that can be reached
  };

  void enter(VertexId v, std::size_t lowest) {
    number_[v] = ++count_;
    path_.push_back({v, lowest});
  }
  EdgeId unwalked(VertexId v) {
    std::vector<EdgeId>& left = edges_at_[v];
    while (!left.empty() && is_walked_[left.back()]) left.pop_back();
    return left.empty() ? EdgeId() : left.back();
  }
  void walk(EdgeId edge) {
    is_walked_[edge] = true;
    Step& step = path_.back();
    const std::size_t tail = number_[step.vertex];
    walked_.push_back({edge, tail});
    const auto [v, w] = graph_.edges[edge];
    const VertexId head = v == step.vertex ? w : v;
    if (number_[head] == 0) {
      enter(head, tail);
    } else {
      step.lowest = std::min(step.lowest, number_[head]);
    }
  }
  void leave() {
    const Step last = path_.back();
    path_.pop_back();
    if (path_.empty()) return;
    Step& step = path_.back();
    if (last.lowest != number_[step.vertex]) {
      step.lowest = std::min(step.lowest, last.lowest);
      return;
    }
    std::vector<EdgeId> edges;
    bool is_first = false;
    while (!is_first) {
      edges.push_back(walked_.back().first);
      is_first = walked_.back().second == last.lowest;
      walked_.pop_back();
    }
    std::sort(edges.begin(), edges.end());
    if (edges.size() > 1) components.push_back(std::move(edges));
  }

  const Graph& graph_;
  std::vector<std::vector<EdgeId>> edges_at_;  ///< descending
  std::vector<std::size_t> number_;            ///< from 1; 0: not seen
  std::vector<bool> is_walked_;
  std::vector<Step> path_;
  std::vector<std::pair<EdgeId, std::size_t>> walked_;  ///< with the numbers of their tails
  std::size_t count_ = 0;
};

}  // namespace

Biconnected biconnected_components(const Graph& graph) {
  Search search(graph);
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) search.from(VertexId(v));
  Biconnected result{std::move(search.components), {}};
  std::stable_sort(result.components.begin(), result.components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  std::vector<bool> is_kept(graph.edges.size(), false);
  for (const auto& component : result.components) {
    for (const EdgeId e : component) is_kept[e] = true;
  }
  for (std::size_t e = 0; e < is_kept.size(); ++e) {
    if (!is_kept[e]) result.dropped.emplace_back(e);
  }
  return result;
}

}  // namespace plumbline::plasm
