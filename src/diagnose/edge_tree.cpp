// A range is halved where its halves overlap least: across x or y, along the strip, or by
// direction.

#include "diagnose/edge_tree.hpp"

#include <algorithm>
#include <limits>

namespace plumbline::diagnose_steps {
namespace {

// Halves that together cover no more of the whole than this are good enough to look no further.
constexpr double kWellSeparated = 1.25;

double product(const PointD& u, const PointD& v) { return u.x * v.x + u.y * v.y; }

}  // namespace

EdgeTree::EdgeTree(const std::vector<Edge>& edges, const std::vector<PointD>& points) {
  items_.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const PointD &a = points[edges[e].tail], &b = points[edges[e].head];
    const double length = distance(a, b);
    const PointD unit =
        length == 0 ? PointD{0, 0} : PointD{(b.x - a.x) / length, (b.y - a.y) / length};
    items_.push_back({a, b, unit, length, EdgeId(e)});
  }
  nodes_.reserve(items_.size());
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

std::uint32_t EdgeTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(bounds(begin, end));
  if (end - begin <= kLeafSize) return at;
  halve(begin, end, nodes_[at]);
  const std::uint32_t middle = begin + (end - begin) / 2;
  build(begin, middle);
  nodes_[at].right = build(middle, end);
  return at;
}

void EdgeTree::halve(std::uint32_t begin, std::uint32_t end, const Node& whole) {
  using Key = double (*)(const Item&, const PointD&);
  const Key by_x = [](const Item& item, const PointD&) { return item.a.x / 2 + item.b.x / 2; };
  const Key by_y = [](const Item& item, const PointD&) { return item.a.y / 2 + item.b.y / 2; };
  const Key by_height = [](const Item& item, const PointD& normal) {
    return product(normal, item.a) / 2 + product(normal, item.b) / 2;
  };
  const Key by_direction = [](const Item& item, const PointD&) { return item.unit.y; };
  const bool is_wide = whole.box.width() >= whole.box.height();
  const auto part = [&](Key key) {
    const auto first = items_.begin() + begin;
    std::nth_element(first, first + (end - begin) / 2, items_.begin() + end,
                     [&](const Item& a, const Item& b) {
                       const double s = key(a, whole.strip.normal), t = key(b, whole.strip.normal);
                       return s != t ? s < t : a.edge < b.edge;
                     });
  };
  Key best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Key key : {is_wide ? by_x : by_y, is_wide ? by_y : by_x, by_height, by_direction}) {
    part(key);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const double both = area(bounds(begin, middle)) + area(bounds(middle, end));
    if (both <= kWellSeparated * area(whole)) return;
    if (best && both >= least) continue;
    best = key;
    least = both;
  }
  part(best);
}

EdgeTree::Node EdgeTree::bounds(std::uint32_t begin, std::uint32_t end) const {
  const auto longest =
      std::max_element(items_.begin() + begin, items_.begin() + end,
                       [](const Item& a, const Item& b) { return a.length < b.length; });
  const PointD normal{-longest->unit.y, longest->unit.x};
  const double height = product(normal, longest->a);
  Node node{{longest->a, longest->a}, {normal, height, height}, begin, end, 0};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const PointD& p : {items_[i].a, items_[i].b}) {
      node.box.include(p);
      node.strip.low = std::min(node.strip.low, product(normal, p));
      node.strip.high = std::max(node.strip.high, product(normal, p));
    }
  }
  return node;
}

/// Of the box or of the strip within it, whichever is less.
double EdgeTree::area(const Node& node) {
  const double diagonal = distance(node.box.low, node.box.high);
  return std::min(node.box.width() * node.box.height(),
                  (node.strip.high - node.strip.low) * diagonal);
}

double EdgeTree::least_distance(const Node& node, const PointD& p) {
  const double height = product(node.strip.normal, p);
  return std::max({0.0, node.box.low.x - p.x, p.x - node.box.high.x, node.box.low.y - p.y,
                   p.y - node.box.high.y, node.strip.low - height, height - node.strip.high});
}

EdgeTree::Foot EdgeTree::nearest(const Item& item, const PointD& p) {
  const PointD off{p.x - item.a.x, p.y - item.a.y};
  const double along = product(item.unit, off);
  PointD foot{item.a.x + along * item.unit.x, item.a.y + along * item.unit.y};
  if (along <= 0) foot = item.a;
  if (along >= item.length) foot = item.b;
  return {foot, quick_length({p.x - foot.x, p.y - foot.y})};
}

}  // namespace plumbline::diagnose_steps
