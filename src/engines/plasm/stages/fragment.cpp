#include <algorithm>
#include <cmath>
#include <map>

#include "plumbline/engines/lar_stages.hpp"
#include "plumbline/engines/plasm_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::plasm {
namespace {

using lar::Box;

SegmentD segment(const Graph& graph, std::size_t e) {
  return {graph.vertices[graph.edges[e][0]], graph.vertices[graph.edges[e][1]]};
}

std::vector<Box> boxes_of(const Graph& graph) {
  std::vector<Box> boxes;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [a, b] = segment(graph, e);
    boxes.push_back(
        {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)});
  }
  return boxes;
}

bool touch(const Box& a, const Box& b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/// As keys of a dictionary by float: -0 is another key than 0, and before it.
struct ByFloat {
  bool operator()(double a, double b) const {
    return a < b || (a == b && std::signbit(a) && !std::signbit(b));
  }
};

}  // namespace

std::vector<std::vector<EdgeId>> partners(const Graph& graph) {
  const std::vector<Box> boxes = boxes_of(graph);
  const Lists<EdgeId> buckets = lar::box_buckets(boxes);
  std::vector<std::vector<EdgeId>> result(boxes.size());
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (const EdgeId e : buckets[b]) {
      for (const EdgeId f : buckets[b]) {
        if (e != f && touch(boxes[e], boxes[f])) result[e].push_back(f);
      }
    }
  }
  for (std::vector<EdgeId>& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    std::stable_sort(list.begin(), list.end(), [&](EdgeId e, EdgeId f) {
      return std::pair(boxes[e][0], boxes[e][2]) < std::pair(boxes[f][0], boxes[f][2]);
    });
  }
  return result;
}

Graph fragment(const Graph& graph, double radius, std::size_t max_cuts) {
  Graph result;
  const auto all_partners = partners(graph);
  std::size_t cuts = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const SegmentD edge = segment(graph, e);
    const std::size_t first = result.vertices.size();
    result.vertices.insert(result.vertices.end(), {edge.a, edge.b});
    std::map<double, VertexId, ByFloat> by_parameter;
    for (const EdgeId other : all_partners[e]) {
      for (const Cut& cut : meet(edge, segment(graph, other), radius).cuts) {
        by_parameter[cut.parameter] = VertexId(result.vertices.size());
        result.vertices.push_back(cut.point);
        if (++cuts > max_cuts) {
          throw Error(ErrorCode::Limit, "edges cut each other in too many places");
        }
      }
    }
    by_parameter[0] = VertexId(first);
    by_parameter[1] = VertexId(first + 1);
    for (auto next = std::next(by_parameter.begin()); next != by_parameter.end(); ++next) {
      const auto [lesser, greater] = std::minmax(std::prev(next)->second, next->second);
      result.edges.push_back({lesser, greater});
      result.edge_sources.push_back(graph.edge_sources[e]);
    }
  }
  return result;
}

}  // namespace plumbline::plasm
