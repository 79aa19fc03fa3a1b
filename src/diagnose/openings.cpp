// Openings as wide as doors: two lines that end facing each other on one line, or two ends of
// walls, drawn by both faces, that are opposite each other. Each end has the nearest one that is
// open to it, if that has it, too.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "diagnose/steps.hpp"
#include "geometry/box_tree.hpp"

namespace plumbline::diagnose_steps {
namespace {

struct Vector {
  Rational x, y;
};
Vector from_to(const Point& p, const Point& q) { return {q.x - p.x, q.y - p.y}; }
Rational dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
Rational cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

/// Where a wall ends: a tip, where b is a, or an edge from a to b as seen from the wall,
/// counter-clockwise.
struct Jamb {
  EdgeId edge;  ///< of a tip the one that ends there
  VertexId a, b;
  Vector outward;  ///< away from the wall
};

class Openings {
 public:
  Openings(const LineGraph& graph, std::span<const VertexId> loose_ends, const Rational& least,
           const Rational& most)
      : graph_(graph),
        complex_(graph.complex()),
        squared_least_(least * least),
        squared_most_(most * most),
        squared_slack_(rational_from(graph_.slack()) * rational_from(graph_.slack())),
        reach_(nearest_double(most)) {
    for (const VertexId v : loose_ends) add_tip(v);
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) add_edge(EdgeId(e));
  }

  std::vector<Opening> find() {
    std::vector<Opening> result;
    if (jambs_.size() < 2) return result;
    std::vector<BoxD> boxes;
    for (const Jamb& jamb : jambs_) boxes.push_back(grown(box_of_jamb(jamb), 4 * graph_.slack()));
    jamb_tree_ = std::make_unique<BoxTree>(boxes);
    std::vector<std::size_t> opposite;
    for (std::size_t i = 0; i < jambs_.size(); ++i) opposite.push_back(nearest_opposite(i));
    for (std::size_t i = 0; i < jambs_.size(); ++i) {
      const std::size_t j = opposite[i];
      if (j == kNone || j < i || opposite[j] != i) continue;
      if (is_clear(jambs_[i], jambs_[j])) result.push_back(opening(jambs_[i], jambs_[j]));
    }
    std::sort(result.begin(), result.end(),
              [](const Opening& o, const Opening& p) { return o.vertices < p.vertices; });
    return result;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  Point at(VertexId v) const { return complex_.vertices[v]; }

  /// Whether a product with u says that something is off by no more than rounding.
  bool is_slight(const Rational& product, const Vector& u) const {
    return product * product <= squared_slack_ * dot(u, u);
  }

  /// How far one gets from v along e straight on, squared.
  Rational squared_run(VertexId v, EdgeId e) const {
    VertexId last = graph_.other_end(e, v);
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const EdgeId next : graph_.edges(last)) {
        const VertexId w = graph_.other_end(next, last);
        const Vector on = from_to(at(last), at(w)), run = from_to(at(v), at(last));
        if (next == e || sgn(dot(run, on)) <= 0 || sgn(cross(run, on)) != 0) continue;
        e = next;
        last = w;
        goes_on = true;
        break;
      }
    }
    return squared_distance(at(v), at(last));
  }

  /// A line that ends there, and is no mere stub beside the least opening.
  void add_tip(VertexId v) {
    const EdgeId e = graph_.edges(v)[0];
    constexpr int kStub = 8;
    if (squared_run(v, e) * kStub * kStub < squared_least_) return;
    jambs_.push_back({e, v, v, from_to(at(graph_.other_end(e, v)), at(v))});
  }

  /// An edge that is no longer than an opening, and all lines at its ends go on to one side of it,
  /// at right angles, for at least its length.
  void add_edge(EdgeId e) {
    if (graph_.approx_length(e) > reach_ * (1 + 0x1p-40)) return;
    const Edge& edge = complex_.edges[e];
    if (graph_.degree(edge.tail) != 2 || graph_.degree(edge.head) != 2) return;
    const EdgeId f = graph_.next(e, edge.tail), g = graph_.next(e, edge.head);
    if (std::min(nearest_sqrt(squared_run(edge.tail, f)), nearest_sqrt(squared_run(edge.head, g))) <
        graph_.approx_length(e) * (1 - 0x1p-40)) {
      return;
    }
    const Vector along = from_to(at(edge.tail), at(edge.head));
    const Vector u = from_to(at(edge.tail), at(graph_.other_end(f, edge.tail)));
    const Vector w = from_to(at(edge.head), at(graph_.other_end(g, edge.head)));
    if (!is_slight(dot(along, u), u) || !is_slight(dot(along, w), w)) return;
    const int side = sgn(cross(along, u));
    if (side == 0 || side != sgn(cross(along, w))) return;
    jambs_.push_back({e, edge.tail, edge.head, {-u.x, -u.y}});
  }

  BoxD box_of_jamb(const Jamb& jamb) const {
    const PointD p = graph_.rounded(jamb.a), q = graph_.rounded(jamb.b);
    const PointD middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
    return {middle, middle};
  }

  std::size_t nearest_opposite(std::size_t i) const {
    const Jamb& jamb = jambs_[i];
    const PointD from = box_of_jamb(jamb).low;
    const double x = nearest_double(jamb.outward.x), y = nearest_double(jamb.outward.y);
    const double length = std::hypot(x, y);
    if (!(length > 0)) return kNone;
    const SegmentD ray{from, {from.x + reach_ * (x / length), from.y + reach_ * (y / length)}};
    std::vector<std::pair<double, std::size_t>> ahead;  // nearest first
    for (const std::size_t j : jamb_tree_->meeting(ray)) {
      ahead.emplace_back(distance(from, box_of_jamb(jambs_[j]).low), j);
    }
    std::sort(ahead.begin(), ahead.end());
    for (const auto& [rough, j] : ahead) {
      if (j == i || !are_opposite(jamb, jambs_[j])) continue;
      const Rational squared = squared_width(jamb, jambs_[j]);
      return squared < squared_least_ || squared > squared_most_ ? kNone : j;
    }
    return kNone;
  }

  Rational squared_width(const Jamb& i, const Jamb& j) const {
    return std::min(squared_distance(at(i.a), at(j.a)), squared_distance(at(i.a), at(j.b)));
  }

  /// Whether the second one is straight ahead of the first and the other way round.
  bool are_opposite(const Jamb& i, const Jamb& j) const {
    if ((i.a == i.b) != (j.a == j.b)) return false;
    if (sgn(dot(i.outward, j.outward)) >= 0) return false;
    const auto is_ahead = [&](VertexId v, VertexId w) {
      const Vector to = from_to(at(v), at(w));
      return sgn(dot(i.outward, to)) > 0 && is_slight(cross(i.outward, to), i.outward) &&
             is_slight(cross(j.outward, to), j.outward);
    };
    return (is_ahead(i.a, j.a) && is_ahead(i.b, j.b)) || (is_ahead(i.a, j.b) && is_ahead(i.b, j.a));
  }

  /// The ends of j that are straight ahead of i.a and of i.b.
  std::pair<VertexId, VertexId> facing(const Jamb& i, const Jamb& j) const {
    if (squared_distance(at(i.a), at(j.a)) <= squared_distance(at(i.a), at(j.b))) {
      return {j.a, j.b};
    }
    return {j.b, j.a};
  }

  /// Whether no edge meets what lies between them.
  bool is_clear(const Jamb& i, const Jamb& j) {
    if (!edge_tree_) {
      std::vector<BoxD> boxes;
      for (const Edge& edge : complex_.edges) {
        const std::array ends{graph_.rounded(edge.tail), graph_.rounded(edge.head)};
        boxes.push_back(grown(plumbline::box_of(ends), 4 * graph_.slack()));
      }
      edge_tree_ = std::make_unique<BoxTree>(boxes);
    }
    const std::array corners{graph_.rounded(i.a), graph_.rounded(i.b), graph_.rounded(j.a),
                             graph_.rounded(j.b)};
    const Point from = midpoint(at(i.a), at(i.b)), to = midpoint(at(j.a), at(j.b));
    const auto [ja, jb] = facing(i, j);
    for (const std::size_t k : edge_tree_->meeting(plumbline::box_of(corners))) {
      const Edge& edge = complex_.edges[k];
      if (EdgeId(k) == i.edge || EdgeId(k) == j.edge) continue;
      const Point p = at(edge.tail), q = at(edge.head);
      if (meets(p, q, from, to) || meets(p, q, at(i.a), at(ja)) || meets(p, q, at(i.b), at(jb))) {
        return false;
      }
    }
    return true;
  }

  /// Whether an edge meets the segment from a to b elsewhere than in its ends.
  static bool meets(const Point& p, const Point& q, const Point& a, const Point& b) {
    const auto is_inside = [&](const Point& x) { return x != a && x != b && on_segment(a, b, x); };
    if (is_inside(p) || is_inside(q)) return true;
    return orientation(a, b, p) * orientation(a, b, q) < 0 &&
           orientation(p, q, a) * orientation(p, q, b) < 0;
  }

  Opening opening(const Jamb& i, const Jamb& j) const {
    Opening result;
    result.where = midpoint(midpoint(at(i.a), at(i.b)), midpoint(at(j.a), at(j.b)));
    result.squared_width = squared_width(i, j);
    result.width = nearest_sqrt(result.squared_width);
    result.vertices = {i.a, i.b, j.a, j.b};
    std::sort(result.vertices.begin(), result.vertices.end());
    result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()),
                          result.vertices.end());
    const auto [ja, jb] = facing(i, j);
    result.across.push_back({std::min(i.a, ja), std::max(i.a, ja)});
    if (i.a != i.b) result.across.push_back({std::min(i.b, jb), std::max(i.b, jb)});
    result.segments = graph_.segments(std::array{i.edge, j.edge});
    return result;
  }

  const LineGraph& graph_;
  const ExactComplex& complex_;
  const Rational squared_least_, squared_most_, squared_slack_;
  const double reach_;
  std::vector<Jamb> jambs_;
  std::unique_ptr<BoxTree> jamb_tree_, edge_tree_;
};

}  // namespace

std::vector<Opening> openings(const LineGraph& graph, std::span<const VertexId> loose_ends,
                              const Range& doors) {
  return Openings(graph, loose_ends, doors.least, doors.most).find();
}

}  // namespace plumbline::diagnose_steps
