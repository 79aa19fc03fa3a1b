#include "diagnose/near_edges.hpp"

#include <algorithm>

namespace plumbline::diagnose_steps {
namespace {

constexpr double kRelativeMargin = 1e-12;  // more than rounding can do to a radius
// Four times the largest coordinate, in slacks: beyond every edge.
constexpr double kLargestReach = 0x1p48;

}  // namespace

Nearest nearest_on_edge(const ExactComplex& complex, VertexId v, EdgeId e) {
  const Edge& edge = complex.edges[e];
  const Point &p = complex.vertices[v], &a = complex.vertices[edge.tail],
              &b = complex.vertices[edge.head];
  const Rational ux = b.x - a.x, uy = b.y - a.y;
  const Rational along = ux * (p.x - a.x) + uy * (p.y - a.y);
  const Rational length2 = ux * ux + uy * uy;
  if (along <= 0) return {squared_distance(p, a), edge.tail, a};
  if (along >= length2) return {squared_distance(p, b), edge.head, b};
  const Rational part = along / length2;
  Point foot{a.x + part * ux, a.y + part * uy};
  Rational squared = squared_distance(p, foot);
  return {std::move(squared), VertexId(), std::move(foot)};
}

NearEdges::NearEdges(const LineGraph& graph, const Rational& within)
    : graph_(graph),
      tree_(graph.complex().edges, graph.rounded()),
      reach_(std::min(nearest_double(within), kLargestReach * graph.slack())) {}

NearEdges::Answer NearEdges::near(VertexId v) const {
  Answer answer;
  const std::vector<Edge>& edges = graph_.complex().edges;
  const PointD& p = graph_.rounded(v);
  double radius = reach_;
  const auto with_margin = [&] { return radius * (1 + kRelativeMargin) + graph_.slack(); };
  double reach = with_margin();
  tree_.visit(p, reach, [&](EdgeId e, const EdgeTree::Foot& near) {
    if (edges[e].tail == v || edges[e].head == v) return;
    answer.edges.push_back({e, near.distance, near.foot});
    while (answer.edges.size() > kMostEdges) {
      answer.cut_short = true;
      if (radius <= graph_.slack()) {
        reach = -1;  // what is that near can't be told apart
        break;
      }
      radius /= 2;
      reach = with_margin();
      std::erase_if(answer.edges, [&](const NearEdge& edge) { return edge.distance > reach; });
    }
  });
  std::sort(answer.edges.begin(), answer.edges.end(), [](const NearEdge& a, const NearEdge& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
  });
  return answer;
}

}  // namespace plumbline::diagnose_steps
