#include <algorithm>
#include <map>
#include <numeric>

#include "geometry/point_d.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

/// The vertices within the radius of one.
class Near {
 public:
  Near(const std::vector<PointD>& vertices, double radius)
      : vertices_(vertices), radius_(radius), by_x_(vertices.size()) {
    std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
    std::stable_sort(by_x_.begin(), by_x_.end(),
                     [&](std::size_t v, std::size_t w) { return vertices_[v] < vertices_[w]; });
  }

  template <class Visit>
  void visit(std::size_t v, const Visit& visit_near) const {
    const PointD& p = vertices_[v];
    auto at = std::lower_bound(by_x_.begin(), by_x_.end(), p.x - radius_,
                               [&](std::size_t w, double x) { return vertices_[w].x < x; });
    for (; at != by_x_.end() && vertices_[*at].x <= p.x + radius_; ++at) {
      if (squared_distance(p, vertices_[*at]) <= radius_ * radius_) visit_near(*at);
    }
  }

 private:
  const std::vector<PointD>& vertices_;
  const double radius_;
  std::vector<std::size_t> by_x_;
};

void take_vertices(Merging& merging, const Graph& fragments, double radius) {
  const Near near(fragments.vertices, radius);
  merging.vertex_map.resize(fragments.vertices.size());
  for (std::size_t v = 0; v < fragments.vertices.size(); ++v) {
    if (merging.vertex_map[v].valid()) continue;
    const VertexId next(merging.kept.size());
    merging.kept.emplace_back(v);
    merging.graph.vertices.push_back(fragments.vertices[v]);
    near.visit(v, [&](std::size_t w) { merging.vertex_map[w] = next; });
    merging.vertex_map[v] = next;
  }
}

}  // namespace

Merging merge(const Graph& fragments, double radius) {
  Merging merging;
  take_vertices(merging, fragments, radius);
  std::map<VertexPair, std::size_t> edge_of;
  std::vector<std::vector<SegmentId>> sources;
  for (std::size_t e = 0; e < fragments.edges.size(); ++e) {
    const auto [lesser, greater] = std::minmax(merging.vertex_map[fragments.edges[e][0]],
                                               merging.vertex_map[fragments.edges[e][1]]);
    if (lesser == greater) continue;
    const VertexPair edge{lesser, greater};
    const auto [found, is_new] = edge_of.try_emplace(edge, sources.size());
    if (is_new) {
      merging.graph.edges.push_back(edge);
      sources.emplace_back();
    }
    std::vector<SegmentId>& all = sources[found->second];
    all.insert(all.end(), fragments.edge_sources[e].begin(), fragments.edge_sources[e].end());
  }
  for (std::vector<SegmentId>& all : sources) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    merging.graph.edge_sources.push_back(all);
  }
  return merging;
}

}  // namespace plumbline::plasm
