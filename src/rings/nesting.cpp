// Rings that do not cross lie in each other with one point or with all.

#include <algorithm>
#include <deque>

#include "rings/ring_locator.hpp"
#include "rings/steps.hpp"

namespace plumbline::rings {
namespace {

class Nesting {
 public:
  Nesting(const Shape& shape, const Meetings& meetings) : shape_(shape), meetings_(meetings) {
    std::vector<BoxD> boxes;
    for (const Walk& walk : shape.walks) {
      locators_.emplace_back(shape.input, shape.complex, walk);
      boxes.push_back(locators_.back().box());
    }
    boxes_ = std::make_unique<BoxTree>(boxes);
  }

  std::vector<RingProblem> find() && {
    for (std::size_t w = 0; w < shape_.walks.size(); ++w) {
      if (!is_usable(w)) continue;
      if (is_hole(w)) {
        look_at_hole(w);
      } else {
        look_at_part(w);
      }
    }
    return std::move(problems_);
  }

 private:
  bool is_hole(std::size_t w) const { return shape_.walks[w].role == RingRole::Hole; }
  bool cross(std::size_t w, std::size_t x) const {
    return meetings_.crossing.contains(std::minmax(w, x));
  }
  bool is_usable(std::size_t w) const { return shape_.walks[w].is_closed && !cross(w, w); }

  /// A point of the first ring, if that lies in the second.
  std::optional<Point> within(std::size_t w, std::size_t container) const {
    const std::optional<Point> p = locators_[container].point_off(shape_.walks[w]);
    return p && locators_[container].contains(*p) ? p : std::nullopt;
  }

  /// The rings of that kind, in these parts, that w lies in; a point of w as it does. None of those
  /// that cannot be told.
  template <class Is>
  std::optional<std::pair<std::size_t, Point>> container(std::size_t w, const Is& is) const {
    for (const std::size_t x : boxes_->meeting(box_of_first(w))) {
      if (x == w || !is_usable(x) || !is(x) || cross(w, x)) continue;
      if (auto p = within(w, x)) return std::pair(x, *std::move(p));
    }
    return std::nullopt;
  }

  /// Where the ring starts: only rings whose boxes have that can have the ring.
  BoxD box_of_first(std::size_t w) const {
    const PointD p = nearest(shape_.complex.vertices[shape_.walks[w].vertices.front()]);
    return {p, p};
  }

  void look_at_hole(std::size_t w) {
    const std::size_t part = shape_.parts[w];
    if (is_usable(part) && !is_hole(part) && !cross(part, w)) {
      const std::optional<Point> p = locators_[part].point_off(shape_.walks[w]);
      if (p && !locators_[part].contains(*p)) add(RingFault::HoleOutside, w, part, *p);
    }
    const auto found =
        container(w, [&](std::size_t x) { return is_hole(x) && shape_.parts[x] == part; });
    if (found) add(RingFault::NestedHoles, w, found->first, found->second);
  }

  /// Within another part w is where it should be only in a hole of that.
  void look_at_part(std::size_t w) {
    std::optional<std::size_t> part;  // that w lies in, as far as its holes were looked at
    Point place;
    for (const std::size_t x : boxes_->meeting(box_of_first(w))) {
      if (x == w || !is_usable(x) || cross(w, x)) continue;
      if (is_hole(x)) {
        if (part == shape_.parts[x] && within(w, x)) part.reset();
        continue;
      }
      if (part) break;
      if (std::optional<Point> p = within(w, x)) {
        part = x;
        place = *std::move(p);
      }
    }
    if (part) add(RingFault::NestedParts, w, *part, std::move(place));
  }

  void add(RingFault fault, std::size_t w, std::size_t other, Point where) {
    const std::size_t a = shape_.walks[w].ring, b = shape_.walks[other].ring;
    problems_.push_back({fault, a, b, std::move(where), std::nullopt,
                         segments_of(shape_, a, a, shape_.walks[w].edges)});
  }

  const Shape& shape_;
  const Meetings& meetings_;
  std::deque<RingLocator> locators_;  ///< per walk
  std::unique_ptr<BoxTree> boxes_;
  std::vector<RingProblem> problems_;
};

}  // namespace

std::vector<RingProblem> nesting(const Shape& shape, const Meetings& meetings) {
  if (shape.walks.size() < 2) return {};
  return Nesting(shape, meetings).find();
}

}  // namespace plumbline::rings
