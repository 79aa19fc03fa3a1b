// A tree of boxes proposes pairs of an exact and a float edge; orientations decide how they meet.

#include "compare/contacts.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

namespace plumbline::compare_steps {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeValue = std::pair<TreeBox, EdgeId>;

constexpr std::size_t kNodeSize = 16;
/// Of a rough coordinate's error: a part of an edge keeps within so much of the box of its ends.
constexpr double kMarginInErrors = 8;

class ContactSearch {
 public:
  ContactSearch(const Sides& sides, const CommonPoints& points)
      : sides_(sides), points_(points), margin_(kMarginInErrors * points.error()) {
    for (const Side side : kBothSides) result_.of_edge[side].resize(sides[side].edge_count());
  }

  Contacts run(const Both<std::vector<EdgeId>>& edges) {
    std::vector<TreeValue> values;
    const double unit = unit_of(Float, edges[Float]);
    for (const EdgeId f : edges[Float]) {
      for (const TreeBox& box : boxes(Float, f, unit)) values.emplace_back(box, f);
    }
    const bgi::rtree<TreeValue, bgi::rstar<kNodeSize>> tree(values);
    std::vector<EdgeId> near;
    for (const EdgeId e : edges[Exact]) {
      near.clear();
      for (const TreeBox& box : boxes(Exact, e, unit)) {
        for (auto it = tree.qbegin(bgi::intersects(box)); it != tree.qend(); ++it) {
          near.push_back(it->second);
        }
      }
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      for (const EdgeId f : near) meet(e, f);
    }
    for (const Side side : kBothSides) {
      for (const EdgeId e : edges[side]) bring_into_order(result_.of_edge[side][e]);
    }
    return std::move(result_);
  }

 private:
  struct Ends {
    std::size_t tail, head;
  };
  Ends ends(Side side, EdgeId e) const {
    const Edge& edge = sides_[side].edges[e];
    return {points_(side, edge.tail), points_(side, edge.head)};
  }
  double extent(const Ends& e) const {
    const PointD &p = points_.rough(e.tail), &q = points_.rough(e.head);
    return std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
  }
  double unit_of(Side side, const std::vector<EdgeId>& edges) const;
  std::vector<TreeBox> boxes(Side side, EdgeId e, double unit) const;
  void meet(EdgeId e, EdgeId f);
  void touch(Side side, EdgeId e, VertexId w, EdgeId f);
  Point crossing(const Ends& e, const Ends& f) const;
  void bring_into_order(std::vector<Contact>& contacts) const;

  const Sides& sides_;
  const CommonPoints& points_;
  const double margin_;
  Contacts result_;
};

/// The average extent of the edges.
double ContactSearch::unit_of(Side side, const std::vector<EdgeId>& edges) const {
  double sum = 0;
  for (const EdgeId e : edges) sum += extent(ends(side, e)) / static_cast<double>(edges.size());
  return sum;
}

/// Boxes that cover the edge: several of a long one, since that of a slanting line is mostly empty.
std::vector<TreeBox> ContactSearch::boxes(Side side, EdgeId e, double unit) const {
  constexpr double kMostBoxes = 1000;
  const Ends at = ends(side, e);
  const PointD &p = points_.rough(at.tail), &q = points_.rough(at.head);
  const double parts = unit > 0 ? std::clamp(std::ceil(extent(at) / unit), 1.0, kMostBoxes) : 1.0;
  const auto count = static_cast<std::size_t>(parts);
  const auto place = [&](std::size_t i) {
    if (i == count) return q;
    const double t = static_cast<double>(i) / parts;
    return PointD{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  };
  std::vector<TreeBox> result;
  for (std::size_t i = 0; i < count; ++i) {
    const PointD a = place(i), b = place(i + 1);
    result.push_back({{std::min(a.x, b.x) - margin_, std::min(a.y, b.y) - margin_},
                      {std::max(a.x, b.x) + margin_, std::max(a.y, b.y) + margin_}});
  }
  return result;
}

Point ContactSearch::crossing(const Ends& e, const Ends& f) const {
  const Point &p = points_.point(e.tail), &q = points_.point(e.head);
  const Point &r = points_.point(f.tail), &s = points_.point(f.head);
  const Rational dx = s.x - r.x, dy = s.y - r.y, ex = q.x - p.x, ey = q.y - p.y;
  const Rational along = ((r.x - p.x) * dy - (r.y - p.y) * dx) / (ex * dy - ey * dx);
  return {p.x + along * ex, p.y + along * ey};
}

/// An exact and a float edge.
void ContactSearch::meet(EdgeId e, EdgeId f) {
  const Ends here = ends(Exact, e), there = ends(Float, f);
  const int tail_of_f = points_.orientation(here.tail, here.head, there.tail);
  const int head_of_f = points_.orientation(here.tail, here.head, there.head);
  if (tail_of_f * head_of_f > 0) return;
  const int tail_of_e = points_.orientation(there.tail, there.head, here.tail);
  const int head_of_e = points_.orientation(there.tail, there.head, here.head);
  if (tail_of_e * head_of_e > 0) return;
  if (tail_of_f * head_of_f < 0 && tail_of_e * head_of_e < 0) {
    const std::size_t number = points_.size() + result_.crossings.size();
    result_.crossings.push_back(crossing(here, there));
    result_.of_edge[Exact][e].push_back({number, {}, f});
    result_.of_edge[Float][f].push_back({number, {}, e});
    return;
  }
  if (tail_of_f == 0) touch(Exact, e, sides_[Float].edges[f].tail, f);
  if (head_of_f == 0) touch(Exact, e, sides_[Float].edges[f].head, f);
  if (tail_of_e == 0) touch(Float, f, sides_[Exact].edges[e].tail, e);
  if (head_of_e == 0) touch(Float, f, sides_[Exact].edges[e].head, e);
}

/// The vertex w of the other side, an end of f, lies on the line of edge e.
void ContactSearch::touch(Side side, EdgeId e, VertexId w, EdgeId f) {
  const Ends at = ends(side, e);
  const std::size_t p = points_(other(side), w);
  if (points_.is_before(p, at.tail) || points_.is_before(at.head, p)) return;
  result_.of_edge[side][e].push_back({p, w, {}});
  if (p == at.tail || p == at.head) return;  // then both are vertices
  result_.of_edge[other(side)][f].push_back({p, {}, e});
}

void ContactSearch::bring_into_order(std::vector<Contact>& contacts) const {
  std::sort(contacts.begin(), contacts.end(), [&](const Contact& a, const Contact& b) {
    return a.point != b.point && result_.place(points_, a) < result_.place(points_, b);
  });
  const auto is_same = [](const Contact& a, const Contact& b) { return a.point == b.point; };
  contacts.erase(std::unique(contacts.begin(), contacts.end(), is_same), contacts.end());
}

}  // namespace

Contacts contacts(const Sides& sides, const CommonPoints& points,
                  const Both<std::vector<EdgeId>>& edges) {
  return ContactSearch(sides, points).run(edges);
}

}  // namespace plumbline::compare_steps
