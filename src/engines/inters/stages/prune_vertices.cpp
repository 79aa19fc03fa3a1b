// Merging of near vertices, section 2.9 (pruneVertices). The members of a cluster are listed as the
// graph library of the original did, breadth first through dictionaries, because their mean depends
// on the order in the last bit, and its quantised value on that bit.

#include <algorithm>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "geometry/point_tree.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inters {
namespace {

std::vector<VertexPair> close_pairs(std::span<const PointD> vertices, double radius,
                                    std::size_t max_pairs) {
  const PointTree tree(vertices);
  std::vector<VertexPair> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    tree.for_each_near(vertices[i], radius, [&](std::size_t j) {
      if (i < j) result.push_back({VertexId(i), VertexId(j)});
    });
    if (result.size() > max_pairs) {
      throw Error(ErrorCode::Limit, "too many pairs of vertices are within the radius");
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The graph of nearness. Each vertex is near itself.
class NearGraph {
 public:
  NearGraph(std::size_t n, std::span<const VertexPair> close) : begin_(n + 1, 0) {
    std::vector<VertexPair> pairs(close.begin(), close.end());
    for (std::size_t v = 0; v < n; ++v) pairs.push_back({VertexId(v), VertexId(v)});
    std::sort(pairs.begin(), pairs.end());
    pairs = HashTable<VertexPair>(pairs).listed();
    for (const auto& [v, w] : pairs) {
      ++begin_[v + 1];
      if (v != w) ++begin_[w + 1];
    }
    for (std::size_t v = 0; v < n; ++v) begin_[v + 1] += begin_[v];
    near_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    for (const auto& [v, w] : pairs) {
      near_[next[v]++] = w;
      if (v != w) near_[next[w]++] = v;
    }
  }

  bool is_alone(std::size_t v) const { return begin_[v + 1] - begin_[v] == 1; }
  /// Those near v, as a dictionary lists them that was given the pairs as a set lists them.
  std::vector<std::size_t> listed(std::size_t v) const {
    HashTable<std::size_t> table;
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) table.insert(near_[i]);
    return table.listed();
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<VertexId> near_;
};

/// The cluster of the vertex; marks its members as visited.
std::vector<std::size_t> cluster_of(std::size_t vertex, const NearGraph& graph,
                                    std::vector<bool>& visited) {
  std::vector<std::size_t> queue{vertex};
  visited[vertex] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (graph.is_alone(queue[i])) continue;
    for (const std::size_t w : graph.listed(queue[i])) {
      if (visited[w]) continue;
      visited[w] = true;
      queue.push_back(w);
    }
  }
  const std::vector<std::size_t> component = HashTable<std::size_t>(queue).listed();
  return HashTable<std::size_t>(component).listed();
}

PointD centroid(std::span<const PointD> points, std::span<const std::size_t> members) {
  PointD sum;
  for (const std::size_t v : members) sum = {sum.x + points[v].x, sum.y + points[v].y};
  const auto n = static_cast<double>(members.size());
  return {sum.x / n, sum.y / n};
}

}  // namespace

Pruned prune_vertices(std::span<const PointD> vertices, double radius, std::size_t max_pairs) {
  check_radius(radius);
  Pruned result;
  result.close = close_pairs(vertices, radius, max_pairs);
  const NearGraph graph(vertices.size(), result.close);
  std::vector<bool> visited(vertices.size(), false);
  result.vertex_map.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (visited[i]) continue;
    const std::vector<std::size_t> cluster = cluster_of(i, graph, visited);
    for (const std::size_t v : cluster) result.vertex_map[v] = VertexId(result.vertices.size());
    if (cluster.size() == 1) {
      result.vertices.push_back(vertices[i]);
      continue;
    }
    result.vertices.push_back(centroid(vertices, cluster));
    std::vector<VertexId> members;
    for (const std::size_t v : cluster) members.emplace_back(v);
    result.clusters.push_back(members);
  }
  return result;
}

}  // namespace plumbline::inters
