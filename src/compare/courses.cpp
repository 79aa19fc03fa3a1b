// At a contact, the direction in which an edge goes on tells what it runs through: beside an edge,
// by the side; at a vertex, by the sector.

#include "compare/courses.hpp"

#include <algorithm>

namespace plumbline::compare_steps {

Courses::Courses(const Sides& sides, const CommonPoints& points, const Contacts& contacts)
    : sides_(sides), points_(points), contacts_(contacts) {
  for (const Side side : kBothSides) around_[side].resize(sides[side].vertices.size());
  for (const Side side : kBothSides) {
    for (const std::vector<Contact>& list : contacts.of_edge[side]) {
      for (const Contact& contact : list) {
        if (!contact.vertex.valid()) continue;
        std::vector<HalfedgeId>& leaving = around_[other(side)][contact.vertex];
        if (leaving.empty()) leaving = around(other(side), contact.vertex);
      }
    }
  }
}

/// The halfedges that leave a vertex, counter-clockwise: first those that run forward, from right
/// below the vertex to right above it.
std::vector<HalfedgeId> Courses::around(Side side, VertexId v) const {
  const auto leaving = sides_.outgoing[side][v];
  std::vector<HalfedgeId> result(leaving.begin(), leaving.end());
  const auto target = [&](HalfedgeId h) { return points_(side, sides_[side].target(h)); };
  std::sort(result.begin(), result.end(), [&](HalfedgeId g, HalfedgeId h) {
    if (is_reversed(g) != is_reversed(h)) return is_reversed(h);
    return points_.orientation(points_(side, v), target(g), target(h)) > 0;
  });
  return result;
}

Course Courses::along(Side there, HalfedgeId h) const {
  const FaceId left = sides_[there].halfedge_face[h];
  return {left, sides_[there].is_antenna(edge_of(h)) ? HalfedgeId() : h};
}

Course Courses::from_vertex(Side there, VertexId w, std::size_t towards, Way way) const {
  const std::vector<HalfedgeId>& leaving = around_[there][w];
  const auto turn = [&](HalfedgeId h) {
    return points_.orientation(points_(there, w), points_(there, sides_[there].target(h)), towards);
  };
  const bool is_back = way == Way::Backward;
  const auto is_not_after = [&](HalfedgeId h) {
    if (is_reversed(h) != is_back) return is_back;
    return turn(h) >= 0;
  };
  const auto after = std::partition_point(leaving.begin(), leaving.end(), is_not_after);
  const HalfedgeId last = after == leaving.begin() ? leaving.back() : *std::prev(after);
  if (is_reversed(last) == is_back && turn(last) == 0) return along(there, last);
  return {sides_[there].halfedge_face[last], {}};
}

Course Courses::from(Side there, const Contact& contact, std::size_t towards, Way way) const {
  if (contact.vertex.valid()) return from_vertex(there, contact.vertex, towards, way);
  const Edge& edge = sides_[there].edges[contact.edge];
  const int turn =
      points_.orientation(points_(there, edge.tail), points_(there, edge.head), towards);
  const bool is_reversed = turn == 0 ? way == Way::Backward : turn < 0;
  const HalfedgeId h = halfedge(contact.edge, is_reversed);
  if (turn == 0) return along(there, h);
  return {sides_[there].halfedge_face[h], {}};
}

std::vector<Piece> Courses::pieces(Side side, EdgeId e) const {
  const Edge& edge = sides_[side].edges[e];
  const std::size_t tail = points_(side, edge.tail), head = points_(side, edge.head);
  const std::vector<Contact>& list = contacts_.of_edge[side][e];
  if (list.empty()) return {{&points_.point(tail), &points_.point(head), {}}};
  std::vector<Piece> result;
  if (list.front().point != tail) {
    Course course = from(other(side), list.front(), tail, Way::Backward);
    if (course.along.valid()) {
      course = {sides_[other(side)].halfedge_face[twin(course.along)], twin(course.along)};
    }
    result.push_back({&points_.point(tail), &contacts_.place(points_, list.front()), course});
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].point == head) break;
    const Point* to =
        i + 1 < list.size() ? &contacts_.place(points_, list[i + 1]) : &points_.point(head);
    result.push_back(
        {&contacts_.place(points_, list[i]), to, from(other(side), list[i], head, Way::Forward)});
  }
  return result;
}

bool Courses::is_contact(Side side, EdgeId e, VertexId end) const {
  const std::vector<Contact>& list = contacts_.of_edge[side][e];
  const std::size_t p = points_(side, end);
  return !list.empty() && (list.front().point == p || list.back().point == p);
}

}  // namespace plumbline::compare_steps
