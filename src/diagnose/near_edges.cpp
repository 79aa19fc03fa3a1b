#include "diagnose/near_edges.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "geometry/point_d.hpp"

namespace plumbline::diagnose_steps {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeValue = std::pair<TreeBox, std::uint32_t>;

constexpr std::size_t kNodeSize = 16;
constexpr double kRelativeMargin = 1e-12;  // more than rounding can do to a radius
// Four times the largest coordinate, in slacks: beyond every edge.
constexpr double kLargestReach = 0x1p48;

PointD nearest_point(const PointD& p, const PointD& a, const PointD& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length == 0) return a;
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  const double along = ux * (p.x - a.x) + uy * (p.y - a.y);
  if (along <= 0) return a;
  if (along >= length) return b;
  return {a.x + along * ux, a.y + along * uy};
}

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

struct NearEdges::Tree {
  explicit Tree(const std::vector<TreeValue>& values) : boxes(values) {}
  bgi::rtree<TreeValue, bgi::rstar<kNodeSize>> boxes;
};

NearEdges::NearEdges(const LineGraph& graph, const Rational& within)
    : graph_(graph), reach_(std::min(nearest_double(within), kLargestReach * graph.slack())) {
  std::vector<TreeValue> values;
  const std::vector<Edge>& edges = graph.complex().edges;
  values.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const PointD &a = graph.rounded(edges[e].tail), &b = graph.rounded(edges[e].head);
    values.emplace_back(TreeBox({a.x, std::min(a.y, b.y)}, {b.x, std::max(a.y, b.y)}),
                        static_cast<std::uint32_t>(e));
  }
  tree_ = std::make_unique<Tree>(values);  // packed
}

NearEdges::~NearEdges() = default;

NearEdges::Answer NearEdges::near(VertexId v) const {
  Answer answer;
  const PointD& p = graph_.rounded(v);
  const std::vector<Edge>& edges = graph_.complex().edges;
  // Edges that end at v are always among the proposals.
  const std::size_t most = kMostProposals + graph_.degree(v);
  for (double radius = reach_;; radius /= 2) {
    answer.edges.clear();
    const double reach = radius * (1 + kRelativeMargin) + graph_.slack();
    const TreeBox around({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach});
    std::size_t proposals = 0;
    for (auto it = tree_->boxes.qbegin(bgi::intersects(around)); it != tree_->boxes.qend(); ++it) {
      if (++proposals > most) break;
      const EdgeId e(it->second);
      if (edges[e].tail == v || edges[e].head == v) continue;
      const PointD foot =
          nearest_point(p, graph_.rounded(edges[e].tail), graph_.rounded(edges[e].head));
      const double distance = plumbline::distance(p, foot);
      if (distance <= reach) answer.edges.push_back({e, distance, foot});
    }
    if (proposals <= most) break;
    answer.cut_short = true;
    if (radius <= graph_.slack()) break;  // what is that near can't be told apart
  }
  std::sort(answer.edges.begin(), answer.edges.end(), [](const NearEdge& a, const NearEdge& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
  });
  return answer;
}

}  // namespace plumbline::diagnose_steps
