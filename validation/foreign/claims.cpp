// Facts that other libraries state of their test cases, computed from exact arrangements.

#include "foreign/claims.hpp"

#include <algorithm>
#include <map>

#include "plumbline/arrange.hpp"

namespace plumbline::foreign {

namespace {

/// Paths arranged together, and which path each segment is of.
struct ArrangedPaths {
  ArrangedPaths(const std::vector<Path>& paths) {
    SegmentSet set;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      add_open(set, paths[p]);
      path_of.resize(set.segments.size(), p);
    }
    complex = arrange(set);
  }

  bool has_repeated_edges() const {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      if (complex.edge_sources[e].size() > 1) return true;
    }
    return false;
  }
  /// Per vertex, how many edges of each path that touches it end there. Requires: no repeated
  /// edges.
  std::vector<std::map<std::size_t, int>> degrees() const {
    std::vector<std::map<std::size_t, int>> result(complex.vertices.size());
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      const std::size_t path = path_of[complex.edge_sources[e][0]];
      ++result[complex.edges[e].tail][path];
      ++result[complex.edges[e].head][path];
    }
    return result;
  }

  ExactComplex complex;
  std::vector<std::size_t> path_of;
};

/// Walks from face to face over all edges, starting outside: `cross(from, to, e)` is called once
/// for each face `to`, when `from` is known; e's left side is `to` if `is_left`.
template <class Cross>
void visit_faces(const ExactComplex& complex, Cross cross) {
  std::vector<std::vector<HalfedgeId>> into(complex.face_count());
  for (std::size_t h = 0; h < 2 * complex.edge_count(); ++h) {
    into[complex.halfedge_face[twin(HalfedgeId(h))]].emplace_back(h);
  }
  std::vector<bool> is_seen(complex.face_count());
  std::vector<FaceId> waiting{kUnbounded};
  is_seen[kUnbounded] = true;
  while (!waiting.empty()) {
    const FaceId from = waiting.back();
    waiting.pop_back();
    for (const HalfedgeId h : into[from]) {  // h has `to` on its left
      const FaceId to = complex.halfedge_face[h];
      if (is_seen[to]) continue;
      is_seen[to] = true;
      cross(from, to, edge_of(h), !is_reversed(h));
      waiting.push_back(to);
    }
  }
}

/// Per face and ring whether the face lies inside. Requires: no repeated edges.
std::vector<std::vector<bool>> inside_rings(const ArrangedPaths& rings, std::size_t count) {
  std::vector<std::vector<bool>> inside(rings.complex.face_count(), std::vector<bool>(count));
  visit_faces(rings.complex, [&](FaceId from, FaceId to, EdgeId e, bool) {
    inside[to] = inside[from];
    inside[to][rings.path_of[rings.complex.edge_sources[e][0]]].flip();
  });
  return inside;
}

bool is_closed(const Path& path) { return path.size() >= 4 && path.front() == path.back(); }

/// Whether the rings bound one connected interior: faces inside the shell and outside all holes.
bool is_valid_polygon(const std::vector<Path>& rings) {
  if (!std::all_of(rings.begin(), rings.end(), is_closed)) return false;
  const ArrangedPaths arranged(rings);
  if (arranged.has_repeated_edges()) return false;
  for (const auto& degrees : arranged.degrees()) {
    for (const auto& [ring, degree] : degrees) {
      if (degree != 2) return false;
    }
  }
  const ExactComplex& complex = arranged.complex;
  const auto inside = inside_rings(arranged, rings.size());
  std::vector<bool> is_interior;
  for (const std::vector<bool>& in : inside) {
    is_interior.push_back(in[0] && std::count(in.begin(), in.end(), true) == 1);
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = halfedge(EdgeId(e), false);
    if (is_interior[complex.halfedge_face[h]] == is_interior[complex.halfedge_face[twin(h)]]) {
      return false;
    }
  }
  return std::count(is_interior.begin(), is_interior.end(), true) == 1;
}

/// Whether valid polygons meet in points only. A face's rings outnumber its holes by how many
/// polygons it is in.
bool are_apart(const std::vector<std::vector<Path>>& polygons) {
  std::vector<Path> rings;
  std::vector<std::size_t> polygon_of;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    rings.insert(rings.end(), polygons[p].begin(), polygons[p].end());
    polygon_of.resize(rings.size(), p);
  }
  const ArrangedPaths arranged(rings);
  if (arranged.has_repeated_edges()) return false;
  for (const std::vector<bool>& in : inside_rings(arranged, rings.size())) {
    std::vector<int> count(polygons.size());
    for (std::size_t r = 0; r < rings.size(); ++r) count[polygon_of[r]] += in[r] ? 1 : 0;
    // In a valid polygon's interior one is in its shell alone, in a hole in two rings.
    if (std::count(count.begin(), count.end(), 1) > 1) return false;
  }
  return true;
}

bool is_simple_path_set(const std::vector<Path>& lines) {
  const ArrangedPaths arranged(lines);
  if (arranged.has_repeated_edges()) return false;
  const auto degrees = arranged.degrees();
  for (std::size_t v = 0; v < degrees.size(); ++v) {
    for (const auto& [line, degree] : degrees[v]) {
      const Path& path = lines[line];
      const Point& p = arranged.complex.vertices[v];
      const bool closed = path.front() == path.back();
      const bool is_end = !closed && (path.front() == p || path.back() == p);
      if (degree != (is_end ? 1 : 2)) return false;
      if (degrees[v].size() > 1 && !is_end) return false;
    }
  }
  return true;
}

bool has_repeated_points(Path points) {
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

bool is_within(int winding, AreaClaim::Rule rule) {
  switch (rule) {
    case AreaClaim::Rule::EvenOdd:
      return winding % 2 != 0;
    case AreaClaim::Rule::NonZero:
      return winding != 0;
    case AreaClaim::Rule::Positive:
      return winding > 0;
    case AreaClaim::Rule::Negative:
      return winding < 0;
  }
  return false;
}

bool is_in(bool subject, bool clip, AreaClaim::Operation operation) {
  switch (operation) {
    case AreaClaim::Operation::Intersection:
      return subject && clip;
    case AreaClaim::Operation::Union:
      return subject || clip;
    case AreaClaim::Operation::Difference:
      return subject && !clip;
    case AreaClaim::Operation::ReverseDifference:
      return clip && !subject;
    case AreaClaim::Operation::Xor:
      return subject != clip;
  }
  return false;
}

}  // namespace

bool is_valid(const Geometry& geometry) {
  const auto is_line = [](const Path& line) {
    return line.empty() || std::any_of(line.begin(), line.end(),
                                       [&](const Point& p) { return !(p == line.front()); });
  };
  const auto is_ring = [](const Path& ring) {
    return ring.empty() || (is_closed(ring) && is_simple_path_set({ring}));
  };
  return std::all_of(geometry.lines.begin(), geometry.lines.end(), is_line) &&
         std::all_of(geometry.rings.begin(), geometry.rings.end(), is_ring) &&
         std::all_of(geometry.polygons.begin(), geometry.polygons.end(), is_valid_polygon) &&
         are_apart(geometry.polygons) &&
         std::all_of(geometry.parts.begin(), geometry.parts.end(), is_valid);
}

bool is_simple(const Geometry& geometry) {
  const auto has_simple_rings = [](const std::vector<Path>& rings) {
    return std::all_of(rings.begin(), rings.end(),
                       [](const Path& ring) { return is_simple_path_set({ring}); });
  };
  return !has_repeated_points(geometry.points) && is_simple_path_set(geometry.lines) &&
         has_simple_rings(geometry.rings) &&
         std::all_of(geometry.polygons.begin(), geometry.polygons.end(), has_simple_rings) &&
         std::all_of(geometry.parts.begin(), geometry.parts.end(), is_simple);
}

ClippedArea clipped_area(const SegmentSet& input, const AreaClaim& claim) {
  const ExactComplex complex = arrange(input);
  struct Windings {
    int subject = 0, clip = 0;
  };
  std::vector<Windings> windings(complex.face_count());
  visit_faces(complex, [&](FaceId from, FaceId to, EdgeId e, bool is_left) {
    windings[to] = windings[from];
    // To the left of a path its winding number is one more than to the right.
    for (const SegmentId s : complex.edge_sources[e]) {
      const Segment segment = input.segments[s];
      const int turn = (segment.a < segment.b) == is_left ? 1 : -1;
      (s < claim.first_clip ? windings[to].subject : windings[to].clip) += turn;
    }
  });
  std::vector<bool> is_inside;
  for (const Windings& w : windings) {
    is_inside.push_back(
        is_in(is_within(w.subject, claim.rule), is_within(w.clip, claim.rule), claim.operation));
  }
  ClippedArea result;
  const std::vector<Rational> areas = face_areas(complex);
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    if (is_inside[f]) result.area += areas[f];
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = halfedge(EdgeId(e), false);
    if (is_inside[complex.halfedge_face[h]] == is_inside[complex.halfedge_face[twin(h)]]) continue;
    const Edge& edge = complex.edges[e];
    result.perimeter +=
        nearest_sqrt(squared_distance(complex.vertices[edge.tail], complex.vertices[edge.head]));
    ++result.edges;
  }
  return result;
}

}  // namespace plumbline::foreign
