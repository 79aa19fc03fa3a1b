// What is left of the edges with the same face on both sides when dangling trees are taken off.

#include <algorithm>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

/// Per edge, whether it is part of a tree that dangles (the dangles of the JTS polygonizer).
std::vector<bool> dangling_trees(const LineGraph& graph) {
  const ExactComplex& complex = graph.complex();
  std::vector<std::size_t> degree;
  std::vector<VertexId> tips;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    degree.push_back(graph.degree(VertexId(v)));
    if (degree.back() == 1) tips.emplace_back(v);
  }
  std::vector<bool> taken(complex.edge_count());
  while (!tips.empty()) {
    const VertexId v = tips.back();
    tips.pop_back();
    for (const EdgeId e : graph.edges(v)) {
      if (taken[e]) continue;
      taken[e] = true;
      const VertexId w = graph.other_end(e, v);
      if (--degree[w] == 1) tips.push_back(w);
    }
  }
  return taken;
}

/// The whole chain that the edge is part of, from the lesser of its ends.
Chain chain_of(const LineGraph& graph, EdgeId e) {
  const VertexId tail = graph.complex().edges[e].tail;
  const Chain forth = graph.chain(tail, e);
  Chain whole = graph.chain(forth.last, forth.edges.back());
  return whole.first < whole.last ? whole : graph.chain(whole.last, whole.edges.back());
}

Defect bridge(const LineGraph& graph, Chain chain) {
  const ExactComplex& complex = graph.complex();
  Defect defect;
  defect.kind = DefectKind::Bridge;
  const Edge& middle = complex.edges[chain.edges[chain.edges.size() / 2]];
  defect.where = midpoint(complex.vertices[middle.tail], complex.vertices[middle.head]);
  if (chain.edges.size() == 1) defect.squared_size = graph.squared_length(chain.edges[0]);
  defect.size = graph.length(chain).rounded();
  defect.vertices = {std::min(chain.first, chain.last), std::max(chain.first, chain.last)};
  defect.segments = graph.segments(chain.edges);
  defect.edges = std::move(chain.edges);
  return defect;
}

}  // namespace

Defects bridges(const Subject& subject) {
  const LineGraph& graph = subject.graph;
  Defects result(subject.most_listed);
  std::vector<bool> seen = dangling_trees(graph);
  for (std::size_t e = 0; e < seen.size(); ++e) {
    if (seen[e] || !graph.complex().is_antenna(EdgeId(e))) continue;
    Chain chain = chain_of(graph, EdgeId(e));
    for (const EdgeId f : chain.edges) seen[f] = true;
    result.add(bridge(graph, std::move(chain)));
  }
  return result;
}

}  // namespace plumbline::diagnose_steps
