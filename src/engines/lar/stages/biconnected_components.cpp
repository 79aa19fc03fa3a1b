#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

using Adjacency =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, std::size_t>>;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Per edge the number of its biconnected component; kNone for isolated points.
std::vector<std::size_t> component_of_edge(const Graph& graph) {
  Adjacency adjacency(graph.vertices.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const Edge& edge = graph.edges[e];
    if (edge.tail != edge.head) boost::add_edge(edge.tail, edge.head, e, adjacency);
  }
  std::vector<std::size_t> component(graph.edges.size(), kNone);
  boost::biconnected_components(
      adjacency, boost::make_iterator_property_map(component.begin(),
                                                   boost::get(boost::edge_index, adjacency)));
  return component;
}

}  // namespace

Biconnected biconnected_components(const Graph& graph) {
  const std::vector<std::size_t> component = component_of_edge(graph);
  std::vector<std::vector<EdgeId>> members(graph.edges.size());
  std::vector<std::size_t> least_first;
  for (std::size_t e = 0; e < component.size(); ++e) {
    if (component[e] == kNone) continue;
    if (members[component[e]].empty()) least_first.push_back(component[e]);
    members[component[e]].push_back(EdgeId(e));
  }
  Biconnected result;
  for (std::size_t c : least_first) {
    if (members[c].size() > 1) {
      result.components.push_back(members[c]);
    } else {
      result.bridges.push_back(members[c].front());
    }
  }
  return result;
}

}  // namespace plumbline::lar
