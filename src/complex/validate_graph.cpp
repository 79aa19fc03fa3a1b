// No two edges meet except at common vertices. Edges run from a vertex to a later one and are
// sorted by their tails, so those that can meet edge i from behind are the next ones whose tail
// does not come after i's head. Isolated vertices take part as edges of one point.

#include <algorithm>
#include <numeric>

#include "complex/validate.hpp"
#include "geometry/filtered_points.hpp"

namespace plumbline {
namespace {

/// An edge or an isolated vertex; `low` and `high` bound y, as nearest doubles (rounding is
/// monotone, so disjoint intervals belong to disjoint edges).
struct Item {
  VertexId tail, head;
  EdgeId edge;
  double low, high;
};

std::vector<Item> items(const ExactComplex& c) {
  std::vector<double> y;
  for (std::size_t v = 0; v < c.vertices.size(); ++v) y.push_back(c.vertices.nearest(v).y);
  std::vector<Item> list;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const auto [tail, head] = c.edges[e];
    list.push_back({tail, head, EdgeId(e), std::min(y[tail], y[head]), std::max(y[tail], y[head])});
  }
  for (const VertexId v : c.face_isolated_vertices.flat()) {
    list.push_back({v, v, EdgeId(), y[v], y[v]});
  }
  std::stable_sort(list.begin(), list.end(), [&](const Item& i, const Item& j) {
    return c.vertices.compare(i.tail, j.tail) < 0;
  });
  return list;
}

class Check {
 public:
  Check(const ExactComplex& complex, Violations& violations)
      : c_(complex), points_(complex.vertices), violations_(violations) {}

  void pair(const Item& i, const Item& j) {
    if (i.edge.valid() && j.edge.valid() && i.tail == j.tail && i.head == j.head) {
      report(Invariant::DuplicateEdge, "two edges join the same vertices", at(i.tail), {}, i, j);
      return;
    }
    if (i.edge.valid() && j.edge.valid() && (apart(i, j) || apart(j, i))) return;
    bool touched = false;
    for (const VertexId v : {i.tail, i.head}) touched |= vertex_inside(v, j, i);
    for (const VertexId v : {j.tail, j.head}) touched |= vertex_inside(v, i, j);
    if (touched || share_vertex(i, j) || !i.edge.valid() || !j.edge.valid()) return;
    if (!separated(i, j) && !separated(j, i)) {
      report(Invariant::Crossing, "two edges cross", crossing(i, j), {}, i, j);
    }
  }

 private:
  Point at(VertexId v) const { return c_.vertices[v]; }

  bool is_same(VertexId v, VertexId w) const { return c_.vertices.compare(v, w) == 0; }

  static bool share_vertex(const Item& i, const Item& j) {
    return i.tail == j.tail || i.tail == j.head || i.head == j.tail || i.head == j.head;
  }

  /// Whether v, of `other`, lies in the interior of item's edge; reports it.
  bool vertex_inside(VertexId v, const Item& item, const Item& other) {
    if (!item.edge.valid() || is_same(v, item.tail) || is_same(v, item.head)) return false;
    if (!on_segment(at(item.tail), at(item.head), at(v))) return false;
    report(Invariant::VertexOnEdge, "a vertex lies in the interior of an edge", at(v), {v}, item,
           other);
    return true;
  }

  /// Whether the ends of j lie on one side of the line through i, none on it.
  bool apart(const Item& i, const Item& j) const { return sides(i, j) > 0; }
  /// The same, or at least one on it.
  bool separated(const Item& i, const Item& j) const { return sides(i, j) >= 0; }
  int sides(const Item& i, const Item& j) const {
    return points_.orientation(i.tail, i.head, j.tail) *
           points_.orientation(i.tail, i.head, j.head);
  }

  Point crossing(const Item& i, const Item& j) const {
    const Point a = at(i.tail), b = at(i.head), p = at(j.tail), q = at(j.head);
    const Rational det = (b.x - a.x) * (q.y - p.y) - (b.y - a.y) * (q.x - p.x);
    const Rational t = ((p.x - a.x) * (q.y - p.y) - (p.y - a.y) * (q.x - p.x)) / det;
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  }

  void report(Invariant invariant, const char* message, Point where, std::vector<VertexId> vertices,
              const Item& i, const Item& j) {
    std::vector<EdgeId> edges;
    for (const Item* item : {&i, &j}) {
      if (item->edge.valid()) edges.push_back(item->edge);
    }
    std::sort(edges.begin(), edges.end());
    violations_.add(
        {invariant, message, std::move(where), std::move(vertices), std::move(edges), {}});
  }

  const ExactComplex& c_;
  const FilteredPoints points_;
  Violations& violations_;
};

}  // namespace

void validate_graph(const ExactComplex& complex, Violations& violations) {
  for (std::size_t v = 1; v < complex.vertices.size(); ++v) {
    if (complex.vertices.compare(v - 1, v) < 0) continue;
    violations.add({Invariant::DuplicateVertex,
                    "two vertices have the same coordinates",
                    complex.vertices[v],
                    {VertexId(v - 1), VertexId(v)},
                    {},
                    {}});
  }
  Check check(complex, violations);
  const std::vector<Item> sorted = items(complex);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Item& item = sorted[i];
    for (std::size_t j = i + 1; j < sorted.size(); ++j) {
      const Item& next = sorted[j];
      if (item.head < next.tail && complex.vertices.compare(item.head, next.tail) < 0) break;
      if (next.high < item.low || item.high < next.low) continue;
      check.pair(item, next);
    }
  }
}

}  // namespace plumbline
