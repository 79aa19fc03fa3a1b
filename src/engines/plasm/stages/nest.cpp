// Nesting: shells inside of shells, then the first face whose box has room.

#include <algorithm>
#include <map>
#include <set>

#include "geometry/point_d.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

BoxD box(const Graph& graph, const Chain& chain) {
  const PointD first = graph.vertices[graph.edges[chain.front().edge][0]];
  BoxD result{first, first};
  for (const SignedEdge& s : chain) {
    for (const VertexId v : graph.edges[s.edge]) result.include(graph.vertices[v]);
  }
  return result;
}

bool contains(const BoxD& outer, const BoxD& inner) {
  return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x && outer.low.y <= inner.low.y &&
         inner.high.y <= outer.high.y;
}

bool is_between(double value, double a, double b) {
  return std::min(a, b) <= value && value <= std::max(a, b);
}

enum class Side { Elsewhere, Right, On };
/// Where the edge is at the height of p: to the right of it, or there.
Side side_of(const PointD& p, const PointD& a, const PointD& b) {
  if (!is_between(p.y, a.y, b.y)) return Side::Elsewhere;
  const bool is_beside = is_between(p.x, a.x, b.x);
  if (a.y == p.y && b.y == p.y) return is_beside ? Side::On : Side::Elsewhere;
  if (a == p || b == p || (a.x == p.x && b.x == p.x)) return Side::On;
  if (a.y == p.y) return a.x > p.x ? Side::Right : Side::Elsewhere;
  if (b.y == p.y) return b.x > p.x ? Side::Right : Side::Elsewhere;
  if (std::max(a.x, b.x) <= p.x) return Side::Elsewhere;
  if (std::min(a.x, b.x) >= p.x) return Side::Right;
  const double x = (p.y - b.y) * (a.x - b.x) / (a.y - b.y) + b.x;
  if (x == p.x) return Side::On;
  return x > p.x ? Side::Right : Side::Elsewhere;
}

/// Which components are in which, of those not in one that is, too; both ways.
class Containment {
 public:
  explicit Containment(std::size_t n) : fathers(n), children(n) {}
  void add(std::size_t child, std::size_t father) {
    fathers[child].insert(father);
    children[father].insert(child);
  }
  void reduce() {
    for (std::size_t middle = 0; middle < fathers.size(); ++middle) {
      for (const std::size_t child : children[middle]) {
        for (const std::size_t outer : fathers[middle]) {
          fathers[child].erase(outer);
          children[outer].erase(child);
        }
      }
    }
  }

  std::vector<std::set<std::size_t>> fathers, children;
};

}  // namespace

bool is_inside(const PointD& p, const Graph& graph, const Chain& edges) {
  bool inside = false;
  for (const SignedEdge& s : edges) {
    const PointD& a = graph.vertices[graph.edges[s.edge][0]];
    const PointD& b = graph.vertices[graph.edges[s.edge][1]];
    const Side side = side_of(p, a, b);
    if (side == Side::On) return false;
    if (side == Side::Right && (a.y > p.y) != (b.y > p.y)) inside = !inside;
  }
  return inside;
}

std::vector<Hole> nest(const Graph& graph, std::span<const Component> components) {
  std::vector<BoxD> boxes;
  for (const Component& c : components) boxes.push_back(box(graph, c.shell));
  Containment containment(components.size());
  for (std::size_t i = 0; i < components.size(); ++i) {
    const PointD& vertex = graph.vertices[graph.edges[components[i].shell.front().edge][0]];
    for (std::size_t j = 0; j < components.size(); ++j) {
      if (i != j && contains(boxes[j], boxes[i]) && is_inside(vertex, graph, components[j].shell)) {
        containment.add(i, j);
      }
    }
  }
  containment.reduce();
  std::vector<Hole> holes;
  for (std::size_t father = 0; father < components.size(); ++father) {
    const std::vector<Chain>& faces = components[father].faces;
    for (const std::size_t child : containment.children[father]) {
      const auto first = std::find_if(faces.begin(), faces.end(), [&](const Chain& face) {
        return contains(box(graph, face), boxes[child]);
      });
      if (first == faces.end()) continue;
      holes.push_back({father, static_cast<std::size_t>(first - faces.begin()), child});
    }
  }
  return holes;
}

}  // namespace plumbline::plasm
