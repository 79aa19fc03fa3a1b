#include <algorithm>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {

std::vector<Box> containment_boxes(const Graph& graph, double margin) {
  std::vector<Box> boxes;
  boxes.reserve(graph.edges.size());
  for (const Edge& edge : graph.edges) {
    const PointD& a = graph.vertices[edge.tail];
    const PointD& b = graph.vertices[edge.head];
    boxes.push_back({std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin,
                     std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin});
  }
  return boxes;
}

}  // namespace plumbline::lar
