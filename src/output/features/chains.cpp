#include "output/features/chains.hpp"

#include <algorithm>

namespace plumbline::features {
namespace {

/// An edge, as it is walked along.
struct Step {
  std::uint32_t edge;
  bool is_against;
};

class Joints {
 public:
  Joints(const std::vector<ChainEdge>& edges, const std::vector<bool>& is_node)
      : edges_(edges), degree_(is_node.size()), edges_at_(is_node.size()), is_node_(is_node) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      for (const std::uint32_t p : {edges[e].a, edges[e].b}) {
        ++degree_[p];
        edges_at_[p] ^= e;
      }
    }
  }

  std::uint32_t start(Step s) const { return s.is_against ? edges_[s.edge].b : edges_[s.edge].a; }
  std::uint32_t end(Step s) const { return s.is_against ? edges_[s.edge].a : edges_[s.edge].b; }
  /// Whether a chain goes on there, coming by this edge.
  bool goes_on(std::uint32_t point, std::uint32_t edge) const {
    return degree_[point] == 2 && !is_node_[point] &&
           edges_[edge].kind == edges_[other(point, edge)].kind;
  }
  Step next(Step s) const {
    const std::uint32_t edge = other(end(s), s.edge);
    return {edge, edges_[edge].a != end(s)};
  }
  static Step reversed(Step s) { return {s.edge, !s.is_against}; }

 private:
  std::uint32_t other(std::uint32_t point, std::uint32_t edge) const {
    return edges_at_[point] ^ edge;
  }

  const std::vector<ChainEdge>& edges_;
  std::vector<std::uint32_t> degree_;
  std::vector<std::uint32_t> edges_at_;  ///< of the numbers of its edges, the exclusive or
  const std::vector<bool>& is_node_;
};

}  // namespace

Chains chains(const std::vector<ChainEdge>& edges, const std::vector<bool>& is_node) {
  const Joints joints(edges, is_node);
  Chains result;
  constexpr std::uint32_t kNone = 0xffffffffU;
  result.chain_of.assign(edges.size(), kNone);
  result.runs_against.resize(edges.size());
  std::vector<std::uint32_t> points;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (result.chain_of[e] != kNone) continue;
    Step back{e, true};
    while (joints.goes_on(joints.end(back), back.edge)) {
      back = joints.next(back);
      if (back.edge == e) break;
    }
    Step step = back.edge == e ? Step{e, false} : Joints::reversed(back);
    points.assign(1, joints.start(step));
    const auto chain = static_cast<std::uint32_t>(result.points.size());
    while (true) {
      result.chain_of[step.edge] = chain;
      result.runs_against[step.edge] = step.is_against;
      points.push_back(joints.end(step));
      if (points.back() == points.front() || !joints.goes_on(points.back(), step.edge)) break;
      step = joints.next(step);
    }
    result.points.push_back(points);
  }
  return result;
}

}  // namespace plumbline::features
