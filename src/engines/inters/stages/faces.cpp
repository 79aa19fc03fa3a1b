// The face walk and the areas, section 2.5 (edgeSlopeOrdering, ordered_csrVE, facesFromComps) and
// surface integration.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// One end of an edge.
struct Dart {
  std::size_t edge;
  std::size_t end;  ///< 0 or 1
};

/// The walk along faces. The original keeps the next edges in a sparse matrix, where what is not
/// stored reads as edge 0.
class Walk {
 public:
  Walk(const std::vector<VertexPair>& edges, const Lists<EdgeId>& order)
      : edges_(edges), next_(2 * edges.size()), visited_(2 * edges.size(), false) {
    for (const NextEdge& entry : ordered_vertex_edges(order)) {
      const bool is_second_end = edges_[entry.edge][1] == entry.vertex;
      next_[2 * entry.edge + (is_second_end ? 1 : 0)] = entry.next;
    }
  }

  /// Adds the faces; returns whether the walk aborted.
  bool run(Lists<VertexId>& faces) {
    std::vector<VertexId> face;
    while (first_search()) {
      face.clear();
      VertexId vertex = edges_[edge_][dart_.end];
      idle_steps_ = 0;
      while (face.empty() || face.front() != vertex) {
        face.push_back(vertex);
        if (!step(vertex)) return true;
      }
      faces.push_back(face);
    }
    return false;
  }

 private:
  bool first_search() {
    while (searched_ < visited_.size() && visited_[searched_]) ++searched_;
    if (searched_ == visited_.size()) return false;
    visited_[searched_] = true;
    dart_ = {searched_ / 2, searched_ % 2};
    edge_ = dart_.edge;
    return true;
  }

  EdgeId next_edge(VertexId vertex) const {
    if (edges_[edge_][0] == vertex) return next_[2 * edge_];
    if (edges_[edge_][1] == vertex) return next_[2 * edge_ + 1];
    return EdgeId(0);
  }

  /// To the other end of the next edge; false where that edge does not bound the vertex.
  bool step(VertexId& vertex) {
    const EdgeId next = next_edge(vertex);
    if (edges_[next][0] != vertex && edges_[next][1] != vertex) return false;
    const std::size_t end = edges_[next][0] == vertex ? 1 : 0;
    vertex = edges_[next][end];
    if (!visited_[2 * next + end]) {
      visited_[2 * next + end] = true;
      edge_ = next;
      idle_steps_ = 0;
    } else if (++idle_steps_ > edges_.size() + 1) {
      // The edge stays while nothing is visited anew, so the vertex alone is the state: it repeats.
      fail(kNoTermination, "the face walk repeats itself", "facesFromComps");
    }
    return true;
  }

  const std::vector<VertexPair>& edges_;
  std::vector<EdgeId> next_;  ///< per dart
  std::vector<bool> visited_;
  std::size_t searched_ = 0;
  Dart dart_{};
  std::size_t edge_ = 0;
  std::size_t idle_steps_ = 0;
};

/// The distinct edges without zero edges, in the order of a set.
std::vector<VertexPair> set_of_edges(std::span<const VertexPair> edges) {
  HashTable<VertexPair> set;
  for (const auto& [v, w] : edges) {
    if (v != w) set.insert({std::min(v, w), std::max(v, w)});
  }
  return set.listed();
}

float as_float(double value) { return static_cast<float>(value); }

/// Signed area of a triangle; cross product and norm in single precision.
double triangle_area(const PointD& o, const PointD& p, const PointD& q) {
  const float ax = as_float(p.x - o.x), ay = as_float(p.y - o.y);
  const float bx = as_float(q.x - o.x), by = as_float(q.y - o.y);
  const float left = ax * by, right = ay * bx;
  const float cross = left - right;
  const float norm = std::sqrt(cross * cross);
  return 0.5 * static_cast<double>(norm) * (cross > 0 ? 1 : cross < 0 ? -1 : 0);
}

}  // namespace

Model remove_vertices(std::span<const PointD> vertices, std::span<const VertexPair> edges,
                      const Vcode& vcode) {
  Model result;
  HashTable<std::string> keys;
  const auto renumbered = [&](VertexId v) {
    const auto [index, is_new] = keys.insert(vcode.text(vertices[v]));
    if (is_new) result.vertices.push_back(vcode.quantised(vertices[v]));
    return VertexId(index);
  };
  for (const auto& [v, w] : edges) {
    const VertexId first = renumbered(v);
    result.edges.push_back({first, renumbered(w)});
  }
  return result;
}

Lists<EdgeId> edge_slope_ordering(const Model& model) {
  std::vector<std::vector<std::pair<double, EdgeId>>> around(model.vertices.size());
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const auto& [v, w] = model.edges[e];
    const PointD& p = model.vertices[v];
    const PointD& q = model.vertices[w];
    const auto degrees = [](double y, double x) {
      return 180 * std::atan2(y, x) / std::numbers::pi;
    };
    around[v].emplace_back(degrees(q.y - p.y, q.x - p.x), e);
    around[w].emplace_back(degrees(p.y - q.y, p.x - q.x), e);
  }
  Lists<EdgeId> result;
  std::vector<EdgeId> edges;
  for (auto& list : around) {
    std::sort(list.begin(), list.end());
    edges.clear();
    for (const auto& [angle, edge] : list) edges.push_back(edge);
    result.push_back(edges);
  }
  return result;
}

std::vector<NextEdge> ordered_vertex_edges(const Lists<EdgeId>& slope_order) {
  std::vector<NextEdge> entries;
  for (std::size_t v = 0; v < slope_order.size(); ++v) {
    const auto around = slope_order[v];
    for (std::size_t i = 0; i < around.size(); ++i) {
      entries.push_back({VertexId(v), around[i], around[(i + 1) % around.size()]});
    }
  }
  return entries;
}

Faces faces_from_components(const Model& model) {
  Faces result;
  result.model = {model.vertices, set_of_edges(model.edges), {}};
  if (result.model.edges.empty()) fail("IndexError", "list index out of range", "facesFromComps");
  Walk walk(result.model.edges, edge_slope_ordering(result.model));
  result.aborted = walk.run(result.model.faces);
  result.areas = surface_integration(result.model);
  return result;
}

std::vector<double> surface_integration(const Model& model) {
  std::vector<double> areas;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const auto face = model.faces[f];
    double area = 0;
    for (std::size_t i = 2; i < face.size(); ++i) {
      area += triangle_area(model.vertices[face[0]], model.vertices[face[i - 1]],
                            model.vertices[face[i]]);
    }
    areas.push_back(std::abs(area));
  }
  return areas;
}

}  // namespace plumbline::inters
