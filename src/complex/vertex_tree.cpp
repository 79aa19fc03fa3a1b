#include "complex/vertex_tree.hpp"

#include <algorithm>
#include <numeric>

namespace plumbline {
namespace {

// Rounding moves a coordinate by at most 2^-53 of the extent, hence a distance (which moves no more
// than its three points do) by less than 2^-50 of it; computing a distance of up to three extents
// adds a few units of 2^-52 of it. The rest is room.
constexpr double kMarginOfExtent = 0x1p-46;
// A segment shorter than this counts as a point: squares that underflow make its length, or any
// other, wrong by less. (They do not overflow: coordinates are below 2^kMaxCoordinateBits.)
constexpr double kLeastLength = 0x1p-500;

}  // namespace

VertexTree::VertexTree(const PointList& vertices) {
  const std::size_t n = vertices.size();
  points_.reserve(n);
  const Point origin = n > 0 ? vertices[n / 2] : Point{};
  for (const Point& p : vertices) {
    points_.push_back(nearest(Point{p.x - origin.x, p.y - origin.y}));
  }
  margin_ = kMarginOfExtent * largest_coordinate(points_) + 4 * kLeastLength;
  for (std::size_t v = 0; v < n; ++v) order_.emplace_back(v);
  if (n > 0) build(0, static_cast<std::uint32_t>(n));
  ordered_.reserve(n);
  for (const VertexId v : order_) ordered_.push_back(points_[v]);
}

void VertexTree::build(std::uint32_t begin, std::uint32_t end) {
  BoxD box{points_[order_[begin]], points_[order_[begin]]};
  for (std::uint32_t i = begin; i < end; ++i) box.include(points_[order_[i]]);
  const std::size_t at = nodes_.size();
  nodes_.push_back({box, begin, end, 0, kNoLabel});
  if (end - begin <= kLeafSize) return;
  const bool by_x = box.width() >= box.height();
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](VertexId v, VertexId w) {
                     const double s = by_x ? points_[v].x : points_[v].y;
                     const double t = by_x ? points_[w].x : points_[w].y;
                     return s != t ? s < t : v < w;
                   });
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

void VertexTree::set_labels(std::span<const std::uint32_t> labels) {
  labels_.assign(labels.begin(), labels.end());
  for (std::size_t at = nodes_.size(); at-- > 0;) {  // children come after their parents
    Node& node = nodes_[at];
    if (node.right != 0) {
      const std::uint32_t left = nodes_[at + 1].label, right = nodes_[node.right].label;
      node.label = left == right ? left : kNoLabel;
      continue;
    }
    node.label = labels_[order_[node.begin]];
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (labels_[order_[i]] != node.label) node.label = kNoLabel;
    }
  }
}

VertexTree::Query::Query(const PointD& from, const PointD& to)
    : a(from), b(to), unit{0, 0}, length(VertexTree::distance(from, to)) {
  if (length < kLeastLength) length = 0;
  if (length > 0) unit = {(b.x - a.x) / length, (b.y - a.y) / length};
}

double VertexTree::Query::distance(const PointD& p) const {
  const double x = p.x - a.x, y = p.y - a.y;
  const double along = x * unit.x + y * unit.y;
  if (along <= 0 || length == 0) return VertexTree::distance(a, p);
  if (along >= length) return VertexTree::distance(b, p);
  return std::abs(unit.x * y - unit.y * x);
}

bool VertexTree::Query::may_reach(const Node& node, double reach) const {
  if (std::min(a.x, b.x) - reach > node.box.high.x || std::max(a.x, b.x) + reach < node.box.low.x ||
      std::min(a.y, b.y) - reach > node.box.high.y || std::max(a.y, b.y) + reach < node.box.low.y) {
    return false;
  }
  if (length == 0) return squared_distance_of_box(a, node.box) <= reach * reach;
  // The line keeps clear of the box if it is further from its centre than its corners reach.
  const double half_x = node.box.width() / 2, half_y = node.box.height() / 2;
  const double x = node.box.low.x + half_x - a.x, y = node.box.low.y + half_y - a.y;
  return std::abs(unit.x * y - unit.y * x) <=
         std::abs(unit.x) * half_y + std::abs(unit.y) * half_x + reach;
}

}  // namespace plumbline
