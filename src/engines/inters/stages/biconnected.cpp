// Hopcroft-Tarjan, section 2.4 (biconnectedComponent, DFV_visit, outputComp), with a stack of its
// own instead of recursion. What a vertex has as number is its depth in the search tree: the
// original hands its counter down by value. Edges that leave the tree go to ancestors, so depth
// does.

#include <algorithm>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

using Adjacency = std::vector<std::vector<VertexId>>;

Adjacency neighbours(const Model& model) {
  Adjacency result(model.vertices.size());
  for (const auto& [v, w] : model.edges) {
    if (v == w) continue;
    result[v].push_back(w);
    result[w].push_back(v);
  }
  for (std::vector<VertexId>& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

class Search {
 public:
  explicit Search(Adjacency adjacency)
      : adjacency_(std::move(adjacency)),
        depth_(adjacency_.size(), 0),
        low_(adjacency_.size(), 0),
        parent_(adjacency_.size()) {}

  Biconnected run() {
    for (std::size_t v = 0; v < adjacency_.size(); ++v) {
      if (depth_[v] == 0) visit_from(VertexId(v));
    }
    std::sort(result_.bridges.begin(), result_.bridges.end());
    return std::move(result_);
  }

 private:
  struct Frame {
    VertexId vertex;
    std::size_t next = 0;  ///< the neighbour to look at
  };

  void enter(VertexId v, std::uint32_t depth) {
    depth_[v] = low_[v] = depth;
    frames_.push_back({v});
  }

  void visit_from(VertexId root) {
    enter(root, 1);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const VertexId u = frame.vertex;
      if (frame.next == adjacency_[u].size()) {
        frames_.pop_back();
        if (!frames_.empty()) leave(frames_.back().vertex, u);
        continue;
      }
      const VertexId v = adjacency_[u][frame.next++];
      if (depth_[v] == 0) {
        edges_.push_back({u, v});
        parent_[v] = u;
        enter(v, depth_[u] + 1);
      } else if (parent_[u] != v && depth_[v] < depth_[u]) {
        edges_.push_back({u, v});
        low_[u] = std::min(low_[u], depth_[v]);
      }
    }
  }

  void leave(VertexId u, VertexId child) {
    if (low_[child] >= depth_[u]) add_component({u, child});
    low_[u] = std::min(low_[u], low_[child]);
  }

  void add_component(const VertexPair& last) {
    HashTable<VertexPair> component;
    for (bool more = true; more;) {
      const VertexPair edge = edges_.back();
      edges_.pop_back();
      component.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
      more = edge != last;
    }
    if (component.size() > 1) {
      result_.components.push_back(component.listed());
    } else {
      result_.bridges.push_back(component.keys().front());
    }
  }

  Adjacency adjacency_;
  std::vector<std::uint32_t> depth_;  ///< from 1; 0 where not visited
  std::vector<std::uint32_t> low_;
  std::vector<VertexId> parent_;
  std::vector<Frame> frames_;
  std::vector<VertexPair> edges_;
  Biconnected result_;
};

}  // namespace

Biconnected biconnected_components(const Model& model) {
  if (model.edges.empty()) fail("ValueError", "max() arg is an empty sequence", "triples2mat");
  return Search(neighbours(model)).run();
}

}  // namespace plumbline::inters
