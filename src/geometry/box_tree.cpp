#include "geometry/box_tree.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>

namespace plumbline {

struct BoxTree::Tree {
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Rectangle = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Rectangle, std::size_t>;

  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> index;

  static Corner corner(const PointD& p) { return {p.x, p.y}; }
  static Rectangle rectangle(const BoxD& box) { return {corner(box.low), corner(box.high)}; }
  static std::vector<Entry> entries(std::span<const BoxD> boxes) {
    std::vector<Entry> result;
    result.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) result.emplace_back(rectangle(boxes[i]), i);
    return result;
  }

  template <class Shape>
  std::vector<std::size_t> meeting(const Shape& shape) const {
    std::vector<std::size_t> found;
    for (auto it = index.qbegin(boost::geometry::index::intersects(shape)); it != index.qend();
         ++it) {
      found.push_back(it->second);
    }
    std::sort(found.begin(), found.end());
    return found;
  }
};

BoxTree::BoxTree(std::span<const BoxD> boxes)
    : tree_(std::make_unique<Tree>(Tree{decltype(Tree::index)(Tree::entries(boxes))})) {}

BoxTree::~BoxTree() = default;

std::vector<std::size_t> BoxTree::meeting(const SegmentD& s) const {
  using Line = boost::geometry::model::segment<Tree::Corner>;
  return tree_->meeting(Line(Tree::corner(s.a), Tree::corner(s.b)));
}

std::vector<std::size_t> BoxTree::meeting(const BoxD& box) const {
  return tree_->meeting(Tree::rectangle(box));
}

}  // namespace plumbline
