// Merging of near vertices, section 2.9 (pruneVertices). The members of a cluster are listed as the
// graph library of the original did, breadth first through dictionaries, because their mean depends
// on the order in the last bit, and its quantised value on that bit.

#include <algorithm>

#include "lar/near_points.hpp"
#include "lar/published/hash_order.hpp"
#include "lar/published/stages.hpp"

namespace plumbline::lar::published {
namespace {

std::vector<VertexPair> close_pairs(std::span<const PointD> vertices, double radius) {
  const NearPoints near_points(vertices, radius);
  std::vector<VertexPair> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    near_points.for_each(i, [&](std::size_t j) {
      if (i < j) result.push_back({VertexId(i), VertexId(j)});
    });
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Per vertex those near it, itself too, in the order in which a graph was given the pairs.
std::vector<HashTable<std::size_t>> near_graph(std::size_t n, std::span<const VertexPair> close) {
  std::vector<VertexPair> pairs(close.begin(), close.end());
  for (std::size_t v = 0; v < n; ++v) pairs.push_back({VertexId(v), VertexId(v)});
  std::sort(pairs.begin(), pairs.end());
  std::vector<HashTable<std::size_t>> graph(n);
  for (const auto& [v, w] : HashTable<VertexPair>(pairs).listed()) {
    graph[v].insert(w);
    graph[w].insert(v);
  }
  return graph;
}

/// The cluster of the vertex; marks its members as visited.
std::vector<std::size_t> cluster_of(std::size_t vertex,
                                    const std::vector<HashTable<std::size_t>>& graph,
                                    std::vector<bool>& visited) {
  std::vector<std::size_t> queue{vertex};
  visited[vertex] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (graph[queue[i]].size() == 1) continue;
    for (const std::size_t w : graph[queue[i]].listed()) {
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

Pruned prune_vertices(std::span<const PointD> vertices, double radius) {
  Pruned result;
  result.close = close_pairs(vertices, radius);
  const auto graph = near_graph(vertices.size(), result.close);
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

}  // namespace plumbline::lar::published
