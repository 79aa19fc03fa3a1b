#include "engines/plasm/explain/result.hpp"

#include <algorithm>
#include <map>

namespace plumbline::plasm {
namespace {

VertexId tail(const Graph& graph, const SignedEdge& s) {
  return graph.edges[s.edge][s.sign < 0 ? 1 : 0];
}
VertexId head(const Graph& graph, const SignedEdge& s) {
  return graph.edges[s.edge][s.sign < 0 ? 0 : 1];
}

/// The closed ways that a chain is made of.
std::vector<std::vector<VertexId>> rings(const Graph& graph, const Chain& chain) {
  std::multimap<VertexId, VertexId> next;
  for (const SignedEdge& s : chain) next.emplace(tail(graph, s), head(graph, s));
  std::vector<std::vector<VertexId>> result;
  while (!next.empty()) {
    std::vector<VertexId> ring;
    VertexId v = next.begin()->first;
    for (auto way = next.begin(); way != next.end(); way = next.find(v)) {
      ring.push_back(v);
      v = way->second;
      next.erase(way);
    }
    result.push_back(std::move(ring));
  }
  return result;
}

Polygon polygon(const Graph& graph, const Chain& face) {
  std::vector<std::vector<VertexId>> all = rings(graph, face);
  Polygon result{std::move(all.front()), {}};
  result.holes.assign(std::make_move_iterator(all.begin() + 1), std::make_move_iterator(all.end()));
  return result;
}

std::vector<Polygon> polygons(const Trace& trace) {
  const Graph& graph = trace.merging.graph;
  std::vector<Polygon> result;
  for (std::size_t c = 0; c < trace.cells.size(); ++c) {
    const std::size_t first = result.size();
    for (const Chain& face : trace.cells[c].faces) result.push_back(polygon(graph, face));
    for (const Hole& hole : trace.holes) {
      if (hole.father != c) continue;
      for (auto& ring : rings(graph, trace.cells[hole.child].shell)) {
        result[first + hole.face].holes.push_back(std::move(ring));
      }
    }
  }
  return result;
}

std::vector<EdgeId> kept_edges(const Trace& trace) {
  std::vector<EdgeId> result;
  for (const std::vector<EdgeId>& edges : trace.components) {
    result.insert(result.end(), edges.begin(), edges.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Graph part(const Graph& graph, const std::vector<EdgeId>& edges) {
  Graph result;
  result.vertices = graph.vertices;
  for (const EdgeId e : edges) {
    result.edges.push_back(graph.edges[e]);
    result.edge_sources.push_back(graph.edge_sources[e]);
  }
  return result;
}

/// The lists with the vertices of edges alone.
CellLists used(const Graph& graph, std::vector<Polygon> faces) {
  CellLists lists;
  lists.lists_all_edges = true;
  std::vector<VertexId> number(graph.vertices.size());
  const auto renumber = [&](VertexId v) {
    if (!number[v].valid()) {
      number[v] = VertexId(lists.vertices.size());
      lists.vertices.push_back(graph.vertices[v]);
    }
    return number[v];
  };
  for (const auto& [v, w] : graph.edges) lists.edges.push_back({renumber(v), renumber(w)});
  for (Polygon& face : faces) {
    for (VertexId& v : face.outer) v = renumber(v);
    for (auto& hole : face.holes) {
      for (VertexId& v : hole) v = renumber(v);
    }
  }
  lists.faces = std::move(faces);
  return lists;
}

}  // namespace

LineWork line_work(const Graph& graph) {
  LineWork result;
  for (const auto& [v, w] : graph.edges) {
    result.segments.push_back({graph.vertices[v], graph.vertices[w]});
  }
  result.sources = graph.edge_sources;
  return result;
}

LineWork kept_work(const Trace& trace) {
  return trace.failure ? line_work(trace.merging.graph)
                       : line_work(part(trace.merging.graph, kept_edges(trace)));
}

FloatComplex result_complex(const Trace& trace) {
  const Graph graph =
      trace.failure ? trace.merging.graph : part(trace.merging.graph, kept_edges(trace));
  FloatComplex complex =
      complex_from_faces(used(graph, trace.failure ? std::vector<Polygon>{} : polygons(trace)));
  std::map<std::pair<PointD, PointD>, std::size_t> edge_at;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const PointD& a = graph.vertices[graph.edges[e][0]];
    const PointD& b = graph.vertices[graph.edges[e][1]];
    edge_at[{std::min(a, b), std::max(a, b)}] = e;
  }
  Lists<SegmentId> sources;
  for (const Edge& edge : complex.edges) {
    const PointD& a = complex.vertices[edge.tail];
    const PointD& b = complex.vertices[edge.head];
    sources.push_back(graph.edge_sources[edge_at.at({std::min(a, b), std::max(a, b)})]);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

}  // namespace plumbline::plasm
