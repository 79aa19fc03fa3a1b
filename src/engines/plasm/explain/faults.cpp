// Looks at faces and holes from outside.

#include "engines/plasm/explain/faults.hpp"

#include <algorithm>
#include <cmath>

#include "engines/lar/explain/cells.hpp"
#include "engines/plasm/explain/result.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

/// Whether the slopes put edges around a vertex out of order. **Exact**.
bool misorders(const Graph& graph) {
  std::vector<std::vector<std::pair<double, VertexId>>> around(graph.vertices.size());
  const auto add = [&](VertexId v, VertexId w) {
    const PointD& p = graph.vertices[v];
    const PointD& q = graph.vertices[w];
    around[v].push_back({std::atan2(q.y - p.y, q.x - p.x), w});
  };
  for (const auto& [v, w] : graph.edges) {
    add(v, w);
    add(w, v);
  }
  for (std::size_t v = 0; v < around.size(); ++v) {
    auto& list = around[v];
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const PointD& p = graph.vertices[v];
    const auto half = [&](VertexId w) {
      const PointD& q = graph.vertices[w];
      return q.y > p.y || (q.y == p.y && q.x < p.x) ? 1 : 0;
    };
    for (std::size_t i = 1; i < list.size(); ++i) {
      const VertexId a = list[i - 1].second, b = list[i].second;
      if (half(a) == half(b) &&
          orientation(exact(p), exact(graph.vertices[a]), exact(graph.vertices[b])) < 0) {
        return true;
      }
    }
  }
  return false;
}

/// The sign of the area, relative to a corner, so that the place does not matter.
bool is_clockwise(const Graph& graph, const Chain& shell) {
  const PointD& o = graph.vertices[graph.edges[shell.front().edge][0]];
  double twice = 0;
  for (const auto& [edge, sign] : shell) {
    const PointD& p = graph.vertices[graph.edges[edge][0]];
    const PointD& q = graph.vertices[graph.edges[edge][1]];
    twice += sign * ((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y));
  }
  return twice < 0;
}

bool touches(const Chain& shell, const Graph& graph, VertexId v) {
  return std::any_of(shell.begin(), shell.end(), [&](const SignedEdge& s) {
    return graph.edges[s.edge][0] == v || graph.edges[s.edge][1] == v;
  });
}

bool has_vertex_inside(const Graph& graph, const Chain& inner, const Chain& outer) {
  return std::any_of(inner.begin(), inner.end(), [&](const SignedEdge& s) {
    return is_inside(graph.vertices[graph.edges[s.edge][0]], graph, outer) ||
           is_inside(graph.vertices[graph.edges[s.edge][1]], graph, outer);
  });
}

std::vector<Misplaced> misplaced(const Trace& trace) {
  const Graph& graph = trace.merging.graph;
  std::vector<Misplaced> result;
  const auto asked = [&](std::size_t c) {
    return graph.edges[trace.cells[c].shell.front().edge][0];
  };
  for (const Hole& hole : trace.holes) {
    const Chain& face = trace.cells[hole.father].faces[hole.face];
    if (!has_vertex_inside(graph, trace.cells[hole.child].shell, face)) {
      result.push_back({Misplaced::Kind::FirstBox, graph.vertices[asked(hole.child)]});
    }
  }
  for (std::size_t child = 0; child < trace.cells.size(); ++child) {
    for (std::size_t father = 0; father < trace.cells.size(); ++father) {
      if (child != father && touches(trace.cells[father].shell, graph, asked(child)) &&
          has_vertex_inside(graph, trace.cells[child].shell, trace.cells[father].shell)) {
        result.push_back({Misplaced::Kind::OnShell, graph.vertices[asked(child)]});
      }
    }
  }
  return result;
}

}  // namespace

Faults faults_of(const Trace& trace, std::size_t threads) {
  Faults faults;
  faults.is_plane = lar::is_plane(kept_work(trace), threads);
  faults.misorders_edges = misorders(trace.merging.graph);
  if (trace.failure) return faults;
  faults.misjudges_areas =
      std::any_of(trace.cells.begin(), trace.cells.end(), [&](const Component& component) {
        return !is_clockwise(trace.merging.graph, component.shell);
      });
  faults.misplaced = misplaced(trace);
  return faults;
}

}  // namespace plumbline::plasm
