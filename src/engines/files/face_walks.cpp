#include "engines/files/face_walks.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace plumbline::files {
namespace {

using Cell = FaceWalks::Cell;

Cell as_set(Cell vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// 0 for directions from +x to below -x, counter-clockwise; 1 for the others.
int half_of(const Point& from, const Point& to) {
  const int up = cmp(to.y, from.y);
  return up > 0 || (up == 0 && to.x > from.x) ? 0 : 1;
}

/// Twice the signed area, as far as its sign goes.
bool is_counter_clockwise(const Cell& walk, const std::vector<PointD>& vertices) {
  Rational sum = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const Point p = exact(vertices[walk[i]]);
    const Point q = exact(vertices[walk[(i + 1) % walk.size()]]);
    sum += p.x * q.y - q.x * p.y;
  }
  return sgn(sum) > 0;
}

}  // namespace

FaceWalks::FaceWalks(const std::vector<PointD>& vertices, std::vector<Cell> neighbours)
    : vertices_(vertices),
      neighbours_(std::move(neighbours)),
      inner_at_(vertices.size()),
      outer_at_(vertices.size()) {
  for (std::size_t v = 0; v < neighbours_.size(); ++v) {
    neighbours_[v] = as_set(std::move(neighbours_[v]));
    std::erase(neighbours_[v], VertexId(v));
  }
  leave_out_dangling();
  sort_by_angle();
  walk();
}

std::optional<Polygon> FaceWalks::around(const Cell& vertices) const {
  if (vertices.empty()) return std::nullopt;
  // The first one by coordinates lies on the outer boundary.
  const VertexId first =
      *std::min_element(vertices.begin(), vertices.end(),
                        [&](VertexId v, VertexId w) { return vertices_[v] < vertices_[w]; });
  std::optional<Polygon> found;
  for (const std::size_t i : inner_at_[first]) {
    const Cell boundary = as_set(inner_[i]);
    if (!std::includes(vertices.begin(), vertices.end(), boundary.begin(), boundary.end())) {
      continue;
    }
    Cell rest;
    std::set_difference(vertices.begin(), vertices.end(), boundary.begin(), boundary.end(),
                        std::back_inserter(rest));
    auto holes = outlines_of(std::move(rest));
    if (!holes) continue;
    if (found) return std::nullopt;
    found = Polygon{inner_[i], std::move(*holes)};
  }
  return found;
}

/// The outlines that have just these vertices; none where there are none.
std::optional<std::vector<Cell>> FaceWalks::outlines_of(Cell rest) const {
  std::vector<Cell> outlines;
  while (!rest.empty()) {
    if (outer_at_[rest.front()].size() != 1) return std::nullopt;
    const Cell& outline = outer_[outer_at_[rest.front()].front()];
    const Cell taken = as_set(outline);
    if (!std::includes(rest.begin(), rest.end(), taken.begin(), taken.end())) return std::nullopt;
    Cell left;
    std::set_difference(rest.begin(), rest.end(), taken.begin(), taken.end(),
                        std::back_inserter(left));
    rest = std::move(left);
    outlines.push_back(outline);
  }
  return outlines;
}

void FaceWalks::leave_out_dangling() {
  std::vector<VertexId> tips;
  for (std::size_t v = 0; v < neighbours_.size(); ++v) {
    if (neighbours_[v].size() == 1) tips.emplace_back(v);
  }
  while (!tips.empty()) {
    const VertexId tip = tips.back();
    tips.pop_back();
    if (neighbours_[tip].size() != 1) continue;
    const VertexId at = neighbours_[tip].front();
    neighbours_[tip].clear();
    std::erase(neighbours_[at], tip);
    if (neighbours_[at].size() == 1) tips.push_back(at);
  }
}

/// Counter-clockwise around each vertex. Vertices at one place go by their numbers.
void FaceWalks::sort_by_angle() {
  for (std::size_t v = 0; v < neighbours_.size(); ++v) {
    const Point middle = exact(vertices_[v]);
    std::vector<std::pair<Point, VertexId>> around;
    for (const VertexId w : neighbours_[v]) around.emplace_back(exact(vertices_[w]), w);
    std::sort(around.begin(), around.end(), [&](const auto& a, const auto& b) {
      const int half = half_of(middle, a.first), other = half_of(middle, b.first);
      if (half != other) return half < other;
      const int turn = orientation(middle, a.first, b.first);
      return turn != 0 ? turn > 0 : a.second < b.second;
    });
    std::transform(around.begin(), around.end(), neighbours_[v].begin(),
                   [](const auto& item) { return item.second; });
  }
}

/// From each side of each edge along the face on its left: at a vertex on to the edge that is next
/// clockwise to the one it came by.
void FaceWalks::walk() {
  std::set<std::pair<VertexId, VertexId>> walked;
  for (std::size_t v = 0; v < neighbours_.size(); ++v) {
    for (const VertexId first : neighbours_[v]) {
      Cell walk;
      std::pair<VertexId, VertexId> at{VertexId(v), first};
      while (walked.insert(at).second) {
        walk.push_back(at.first);
        const Cell& around = neighbours_[at.second];
        const auto from = std::find(around.begin(), around.end(), at.first);
        at = {at.second, from == around.begin() ? around.back() : *(from - 1)};
      }
      if (walk.empty()) continue;
      const bool is_inner = is_counter_clockwise(walk, vertices_);
      auto& walks = is_inner ? inner_ : outer_;
      auto& at_vertex = is_inner ? inner_at_ : outer_at_;
      for (const VertexId w : as_set(walk)) at_vertex[w].push_back(walks.size());
      walks.push_back(std::move(walk));
    }
  }
}

}  // namespace plumbline::files
