// Step 8: the point inside each face. A horizontal line between two heights of vertices of its
// boundary meets that inside edges only, and passes from the outside to the inside and back; the
// edges of an antenna, which the boundary has twice, only divide what is inside.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "steps.hpp"

namespace plumbline_checker {
namespace {

mpq_class rational(const Number& number) { return {number.numerator, number.denominator}; }
bool is_less(const Number& a, const Number& b) { return compare(a, b) < 0; }

/// Whether b - a < d - c. **Exact**; doubles decide where they can, by the bound of `compare`.
bool is_narrower(const Number& a, const Number& b, const Number& c, const Number& d) {
  const double difference = (d.near - c.near) - (b.near - a.near);
  const double bound =
      0x1p-48 * (std::abs(a.near) + std::abs(b.near) + std::abs(c.near) + std::abs(d.near));
  if (difference > bound) return true;
  if (difference < -bound) return false;
  return rational(b) - rational(a) < rational(d) - rational(c);
}

/// The middle of the first of the widest gaps between numbers that ascend: those from number 0,
/// `step`, 2 `step`, ... to the next one.
template <class Get>
mpq_class middle_of_widest(std::size_t count, std::size_t step, const Get& number) {
  std::size_t widest = 0;
  for (std::size_t i = step; i + 1 < count; i += step) {
    if (is_narrower(number(widest), number(widest + 1), number(i), number(i + 1))) widest = i;
  }
  return (rational(number(widest)) + rational(number(widest + 1))) / 2;
}

class Interior {
 public:
  Interior(const Input& input, const Certificate& certificate, const Cycles& cycles)
      : input_(input), certificate_(certificate), cycles_(cycles) {}

  std::string point(const Face& face) {
    edges_.clear();
    vertices_.clear();
    add(face.outer);
    for (const Index cycle : face.holes) add(cycle);
    vertices_.insert(vertices_.end(), face.isolated.begin(), face.isolated.end());
    std::sort(vertices_.begin(), vertices_.end(),
              [&](Index v, Index w) { return is_less(height(v), height(w)); });
    const auto is_same = [&](Index v, Index w) { return height(v) == height(w); };
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end(), is_same), vertices_.end());
    const mpq_class y = middle_of_widest(
        vertices_.size(), 1, [&](std::size_t i) -> auto& { return height(vertices_[i]); });
    const std::vector<Number> met = crossings(Number(y.get_num(), y.get_den()));
    const mpq_class x = middle_of_widest(
        met.size(), 2, [&](std::size_t i) -> auto& { return met[i]; });
    return x.get_str() + ' ' + y.get_str();
  }

 private:
  void add(Index cycle) {
    for (const Index* h = cycles_.halfedges.begin(cycle); h != cycles_.halfedges.end(cycle); ++h) {
      edges_.push_back(*h / 2);
      const Edge& edge = certificate_.edges[*h / 2];
      vertices_.push_back(*h % 2 == 0 ? edge.tail : edge.head);
    }
  }

  const Number& height(Index v) const { return certificate_.vertices[v].y; }

  /// The x, ascending, where the edges meet the line at a height.
  std::vector<Number> crossings(const Number& y) const {
    std::vector<Number> result;
    for (const Index e : edges_) {
      const auto [tail, head] = certificate_.edges[e];
      if (is_less(height(tail), y) == is_less(height(head), y)) continue;
      const Line& line = input_.segments[*certificate_.segments.begin(e)].line;
      mpq_class x(line.c * y.denominator - line.b * y.numerator, line.a * y.denominator);
      x.canonicalize();
      result.emplace_back(x.get_num(), x.get_den());
    }
    std::sort(result.begin(), result.end(), is_less);
    return result;
  }

  const Input& input_;
  const Certificate& certificate_;
  const Cycles& cycles_;
  std::vector<Index> edges_;     ///< of the face's boundary, antennas twice
  std::vector<Index> vertices_;  ///< of it, then one of each height
};

}  // namespace

void check_inside(const Input& input, const Certificate& certificate, const Cycles& cycles,
                  const std::vector<Face>& faces) {
  Interior interior(input, certificate, cycles);
  for (Index f = 0; f < faces.size(); ++f) {
    require("the point inside face " + std::to_string(f), certificate.inside[f],
            f == 0 ? "-" : interior.point(faces[f]), certificate.face_line + f);
  }
}

}  // namespace plumbline_checker
