// Cycles of edges and their polylines, section 2.12 (boundaryCycles, structBoundaryModel,
// boundaryModel2polylines).

#include <algorithm>
#include <map>
#include <optional>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// The first edge other than `e` in a set of the edges.
std::optional<std::size_t> another(const std::vector<std::size_t>& edges, std::size_t e) {
  const std::vector<std::size_t> set = HashTable<std::size_t>(edges).listed();
  const auto found = std::find_if(set.begin(), set.end(), [e](std::size_t f) { return f != e; });
  return found == set.end() ? std::nullopt : std::optional(*found);
}

[[noreturn]] void fail_walk(const char* error, const char* message) {
  fail(error, message, "boundaryCycles");
}

struct Step {
  std::size_t edge;
  VertexId vertex;
  friend bool operator==(const Step&, const Step&) = default;
};

/// Walks from edge to edge, taking each out of the list of those left.
class EdgeWalk {
 public:
  explicit EdgeWalk(std::span<const VertexPair> edges) : edges_(edges), left_(edges.size(), true) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (const VertexId v : edges[e]) edges_at_[v].push_back(e);
    }
  }

  std::vector<std::vector<Step>> run() {
    std::vector<std::vector<Step>> cycles;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (left_[e]) cycles.push_back(cycle_from({e, edges_[e][0]}));
    }
    return cycles;
  }

 private:
  std::vector<Step> cycle_from(Step step) {
    std::vector<Step> cycle;
    do {
      cycle.push_back(step);
      const std::optional<std::size_t> next = another(edges_at_[step.vertex], step.edge);
      if (!next) fail_walk("IndexError", "list index out of range");
      if (!left_[*next]) fail_walk("ValueError", "list.remove(x): x not in list");
      left_[*next] = false;
      const VertexPair& edge = edges_[*next];
      if (edge[0] == edge[1]) fail_walk("IndexError", "list index out of range");
      step = {*next, edge[0] == step.vertex ? edge[1] : edge[0]};
    } while (step != cycle.front());
    return cycle;
  }

  std::span<const VertexPair> edges_;
  std::vector<bool> left_;
  std::map<VertexId, std::vector<std::size_t>> edges_at_;
};

SignedCycle signed_cycle(std::span<const VertexPair> edges, const std::vector<Step>& cycle) {
  SignedCycle result;
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const Step& before = cycle[k == 0 ? cycle.size() - 1 : k - 1];
    const bool along = edges[cycle[k].edge] == VertexPair{before.vertex, cycle[k].vertex};
    const auto edge = static_cast<std::ptrdiff_t>(cycle[k].edge);
    result.push_back(along ? edge : -edge);
  }
  return result;
}

/// The boundary's edges in order and direction. Edge 0 has no sign, so it counts as reversed; it is
/// the first, and turned where it starts with the same vertex as the second.
std::vector<VertexPair> directed_edges(std::span<const VertexPair> edges) {
  std::vector<VertexPair> result;
  for (const SignedCycle& cycle : boundary_cycles(edges)) {
    for (const std::ptrdiff_t number : cycle) {
      const VertexPair& edge = edges[static_cast<std::size_t>(std::abs(number))];
      result.push_back(number > 0 ? edge : VertexPair{edge[1], edge[0]});
    }
  }
  if (result.size() < 2) fail("IndexError", "list index out of range", "structBoundaryModel");
  if (result[0][0] == result[1][0]) std::swap(result[0][0], result[0][1]);
  return result;
}

/// The edges over vertices renumbered, in the order of a set (struct2lar).
Model boundary_model(std::span<const PointD> vertices, std::span<const VertexPair> edges,
                     const Vcode& vcode) {
  std::vector<VertexId> used;
  for (const VertexPair& edge : edges) used.insert(used.end(), edge.begin(), edge.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Model result;
  HashTable<std::string> keys;
  std::map<VertexId, VertexId> renumbered;
  for (const VertexId v : used) {
    const auto [index, is_new] = keys.insert(vcode.text(vertices[v]));
    if (is_new) result.vertices.push_back(vcode.quantised(vertices[v]));
    renumbered[v] = VertexId(index);
  }
  HashTable<VertexPair> set;
  for (const auto& [v, w] : edges) {
    set.insert({std::min(renumbered[v], renumbered[w]), std::max(renumbered[v], renumbered[w])});
  }
  result.edges = set.listed();
  return result;
}

}  // namespace

std::vector<SignedCycle> boundary_cycles(std::span<const VertexPair> edges) {
  std::vector<SignedCycle> result;
  for (const std::vector<Step>& cycle : EdgeWalk(edges).run()) {
    result.push_back(signed_cycle(edges, cycle));
  }
  return result;
}

std::vector<Polyline> boundary_polylines(std::span<const PointD> vertices,
                                         std::span<const VertexPair> edges, const Vcode& vcode) {
  const Model model = boundary_model(vertices, edges, vcode);
  std::map<VertexId, VertexId> successor;
  HashTable<std::size_t> starts;
  for (const auto& [v, w] : directed_edges(model.edges)) {
    successor[v] = w;
    starts.insert(v);
  }
  std::vector<bool> visited(model.vertices.size(), false);
  std::vector<Polyline> result;
  for (const std::size_t start : starts.listed()) {
    if (visited[start]) continue;
    Polyline polyline;
    for (VertexId v(start); !visited[v]; v = successor[v]) {
      if (!successor.contains(v)) fail("KeyError", "no successor", "boundaryModel2polylines");
      visited[v] = true;
      polyline.push_back(model.vertices[v]);
    }
    polyline.push_back(model.vertices[start]);
    result.push_back(std::move(polyline));
  }
  return result;
}

}  // namespace plumbline::inters
