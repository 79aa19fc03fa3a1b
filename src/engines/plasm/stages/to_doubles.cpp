#include <cmath>
#include <map>
#include <string>

#include "plumbline/engines/plasm_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::plasm {
namespace {

/// The square of a product of two is finite.
constexpr double kLargest = 0x1p500;

PointD rounded(const NumberPoint& point, std::size_t segment) {
  PointD p = nearest(point);
  if (!(std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest)) {
    throw Error(ErrorCode::BadInput,
                "coordinate of more than 2^500 in segment " + std::to_string(segment), {},
                to_text(point));
  }
  return {p.x + 0.0, p.y + 0.0};  // no -0, which is another key to the original
}

}  // namespace

Graph to_doubles(const SegmentSet& input) {
  Graph graph;
  std::map<PointD, VertexId> vertices;
  const auto vertex = [&](const PointD& p) {
    const auto [found, is_new] = vertices.try_emplace(p, VertexId(graph.vertices.size()));
    if (is_new) graph.vertices.push_back(p);
    return found->second;
  };
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    const PointD a = rounded({n[0], n[1]}, s);
    const PointD b = rounded({n[2], n[3]}, s);
    if (a == b) continue;
    const VertexId v = vertex(a), w = vertex(b);
    graph.edges.push_back({std::min(v, w), std::max(v, w)});
    graph.edge_sources.push_back(std::array{SegmentId(s)});
  }
  return graph;
}

}  // namespace plumbline::plasm
