// Merging of near vertices: the relation of nearness from a KD-tree, its transitive closure by
// union-find, each class contracted to its centroid.

#include <algorithm>

#include "engines/lar/stages/crowds.hpp"
#include "geometry/point_tree.hpp"
#include "geometry/union_find.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

/// The mean, relative to the first member so that what members have in common stays exact.
PointD centroid(std::span<const PointD> points, std::span<const VertexId> members) {
  const PointD& origin = points[members.front()];
  double dx = 0, dy = 0;
  for (VertexId v : members) {
    dx += points[v].x - origin.x;
    dy += points[v].y - origin.y;
  }
  const double n = static_cast<double>(members.size());
  return {origin.x + dx / n + 0.0, origin.y + dy / n + 0.0};
}

/// Unites every point with all that are near it, except where a crowd spares the search.
void unite_near(std::span<const PointD> points, double radius, UnionFind& classes) {
  const PointTree tree(points);
  const auto search = [&](std::size_t i) {
    tree.for_each_near(points[i], radius, [&](std::size_t other) { classes.unite(i, other); });
  };
  Crowds crowds(points, radius, classes);
  // One point of each crowd first, which unites most that there is to unite.
  for (std::size_t i : crowds.representatives()) search(i);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!crowds.is_united_around(i)) search(i);
  }
}

/// The classes, ascending by their least member.
std::vector<std::vector<VertexId>> near_classes(std::span<const PointD> points, double radius) {
  UnionFind classes(points.size());
  unite_near(points, radius, classes);
  std::vector<std::vector<VertexId>> members(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) members[classes.find(i)].push_back(VertexId(i));
  std::erase_if(members, [](const auto& list) { return list.empty(); });
  return members;
}

}  // namespace

Pruning prune_vertices(std::span<const PointD> vertices, double radius) {
  Pruning result;
  if (vertices.empty()) return result;
  struct Class {
    PointD centroid;
    std::vector<VertexId> members;
  };
  std::vector<Class> classes;
  for (std::vector<VertexId>& members : near_classes(vertices, radius)) {
    const PointD point = centroid(vertices, members);
    classes.push_back({point, std::move(members)});
  }
  std::stable_sort(classes.begin(), classes.end(),
                   [](const Class& s, const Class& t) { return s.centroid < t.centroid; });
  result.vertex_map.resize(vertices.size());
  for (const Class& c : classes) {
    for (VertexId v : c.members) result.vertex_map[v] = VertexId(result.vertices.size());
    result.vertices.push_back(c.centroid);
    if (c.members.size() > 1) result.clusters.push_back(c.members);
  }
  return result;
}

}  // namespace plumbline::lar
