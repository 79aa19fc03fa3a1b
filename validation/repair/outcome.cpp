// Which room is where is told by points inside the rooms, and what is next to what by counting;
// nothing of what made the repair has a part in it.

#include "repair/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "plumbline/arrange.hpp"

namespace plumbline::repairs {
namespace {

double length(const ExactComplex& complex, const Edge& edge) {
  const PointD p = complex.vertices.nearest(edge.tail), q = complex.vertices.nearest(edge.head);
  return std::hypot(p.x - q.x, p.y - q.y);
}

/// Faces that share an edge.
std::size_t count_of_neighbours(const ExactComplex& complex) {
  std::set<std::pair<FaceId, FaceId>> pairs;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const FaceId f = complex.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId g = complex.halfedge_face[halfedge(EdgeId(e), true)];
    if (f != g) pairs.emplace(std::min(f, g), std::max(f, g));
  }
  return pairs.size();
}

/// The rooms of a plan as a drawing has them.
struct Found {
  std::vector<FaceId> face;    ///< per room
  std::vector<char> is_there;  ///< per room, with its area
  std::vector<FaceId> others;  ///< faces without a room
  bool is_exact = true;
  bool has_neighbours = true;  ///< as many as there should be

  bool is_right() const {
    return others.empty() && has_neighbours && std::ranges::find(is_there, 0) == is_there.end();
  }
};

Found found(const ExactComplex& right, const std::vector<Room>& rooms, const ExactComplex& complex,
            const Rational& size) {
  Found result;
  std::vector<Point> points;
  for (const Room& room : rooms) points.push_back(room.inside);
  result.face = locate_all(complex, points);
  const std::vector<Rational> areas = face_areas(complex);
  std::vector<std::size_t> count(complex.face_count());
  for (const FaceId f : result.face) ++count[f];
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const FaceId f = result.face[r];
    const Rational off = abs(areas[f] - rooms[r].area);
    const bool is_there = f != kUnbounded && count[f] == 1 &&
                          nearest_double(off) <= nearest_double(size) * rooms[r].perimeter;
    result.is_there.push_back(is_there ? 1 : 0);
    result.is_exact = result.is_exact && is_there && sgn(off) == 0;
  }
  for (std::size_t f = 1; f < count.size(); ++f) {
    if (count[f] == 0) result.others.emplace_back(f);
  }
  result.has_neighbours = count_of_neighbours(complex) == count_of_neighbours(right);
  return result;
}

/// Whether something was refused within twice the size of a face.
bool is_near_refusal(const ExactComplex& complex, FaceId f, const Repair& repair,
                     const Rational& size) {
  const Rational reach = 2 * size;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Edge& edge = complex.edges[e];
    if (complex.halfedge_face[halfedge(EdgeId(e), false)] != f &&
        complex.halfedge_face[halfedge(EdgeId(e), true)] != f) {
      continue;
    }
    const Point a = complex.vertices[edge.tail], b = complex.vertices[edge.head];
    for (const Refusal& refusal : repair.refused) {
      if (squared_distance(refusal.where, a, b) <= reach * reach) return true;
    }
  }
  return false;
}

bool is_listed(const Repair& repair, FaceId FaceOutcome::*side, FaceId f) {
  return std::ranges::any_of(repair.faces, [&](const FaceOutcome& o) { return o.*side == f; });
}

}  // namespace

std::vector<Room> rooms_of(const ExactComplex& complex) {
  const std::vector<Rational> areas = face_areas(complex);
  std::vector<Room> result;
  for (std::size_t f = 1; f < areas.size(); ++f) {
    result.push_back({interior_point(complex, FaceId(f)), areas[f], 0});
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const bool reversed : {false, true}) {
      const FaceId f = complex.halfedge_face[halfedge(EdgeId(e), reversed)];
      if (f != kUnbounded) result[f - 1].perimeter += length(complex, complex.edges[e]);
    }
  }
  return result;
}

Judgement judged(const Plan& plan, const Repair& repair) {
  const ExactComplex right = arrange(plan.right);
  const ExactComplex before = arrange(plan.damaged), after = arrange(repair.output);
  const std::vector<Room> rooms = rooms_of(right);
  const Found was = found(right, rooms, before, plan.size);
  const Found is = found(right, rooms, after, plan.size);
  Judgement result;
  if (is.is_right()) {
    result.outcome = is.is_exact ? Outcome::Exact : Outcome::Right;
    return result;
  }
  const auto worsen = [&](Outcome to, const Point& where) {
    if (result.where.empty() || to > result.outcome) result.where = to_text(where);
    result.outcome = std::max(result.outcome, to);
  };
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (is.is_there[r] != 0) continue;
    const bool was_there = was.is_there[r] != 0;
    result.harmed += was_there ? 1 : 0;
    // The unbounded face is on the list whenever anything is closed or opened.
    const bool is_said =
        (was.face[r] != kUnbounded && is_listed(repair, &FaceOutcome::before, was.face[r])) ||
        (is.face[r] != kUnbounded && is_listed(repair, &FaceOutcome::after, is.face[r])) ||
        is_near_refusal(right, FaceId(r + 1), repair, plan.size);
    worsen(is_said     ? Outcome::Listed
           : was_there ? Outcome::Harm
                       : Outcome::Unsaid,
           rooms[r].inside);
  }
  const std::vector<Rational> areas = face_areas(after), old_areas = face_areas(before);
  for (const FaceId f : is.others) {
    const Point inside = interior_point(after, f);
    const bool is_said =
        is_listed(repair, &FaceOutcome::after, f) || is_near_refusal(after, f, repair, plan.size);
    const bool was_there = old_areas[locate(before, inside)] == areas[f];
    worsen(is_said ? Outcome::Listed : was_there ? Outcome::Unsaid : Outcome::Harm, inside);
  }
  if (result.where.empty()) worsen(Outcome::Unsaid, rooms.front().inside);  // neighbours
  return result;
}

}  // namespace plumbline::repairs
