#include "read/dxf/polyline.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "geometry/point_d.hpp"
#include "geometry/text_rounding.hpp"
#include "read/dxf/curves.hpp"

namespace plumbline::dxf {
namespace {

// Flags of a POLYLINE and of its VERTEX records, DXF reference.
constexpr std::int64_t kSplineFit = 4;
constexpr std::int64_t kInSpace = 8;
constexpr std::int64_t kMesh = 16;
constexpr std::int64_t kClosedColumns = 32;
constexpr std::int64_t kPolyface = 64;
constexpr std::int64_t kFrameVertex = 16;
constexpr std::int64_t kMeshVertex = 64;
constexpr std::int64_t kFaceVertex = 128;

bool has(std::int64_t flags, std::int64_t flag) { return (flags & flag) != 0; }

/// The grid of rows and columns, each edge once.
DrawnEntity draw_mesh(const Polyline& mesh) {
  if (has(mesh.flags, kSplineFit) || mesh.smoothing != 0) throw Unusable{"smoothed mesh", {}};
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  if (mesh.rows < 1 || mesh.columns < 1 || count % mesh.rows != 0 ||
      mesh.columns != count / mesh.rows) {
    throw Unusable{"mesh of " + std::to_string(mesh.rows) + " x " + std::to_string(mesh.columns) +
                       " with " + std::to_string(count) + " vertices",
                   {}};
  }
  const auto rows = static_cast<std::size_t>(mesh.rows);
  const auto columns = static_cast<std::size_t>(mesh.columns);
  DrawnEntity drawn;
  const auto join = [&](std::size_t a, std::size_t b) {
    drawn.segments.push_back(mesh.vertices[a].point, mesh.vertices[b].point);
  };
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t at = i * columns + j;
      if (j + 1 < columns) join(at, at + 1);
      if (j + 1 == columns && has(mesh.flags, kClosedColumns)) join(at, i * columns);
      if (i + 1 < rows) join(at, at + columns);
      if (i + 1 == rows && has(mesh.flags, kClosed)) join(at, j);
    }
  }
  return drawn;
}

void draw_polyface_face(const PolylineVertex& face, const std::vector<NumberPoint>& points,
                        bool draws_hidden, DrawnEntity& drawn) {
  const auto end = std::find(face.face.begin(), face.face.end(), 0);
  const auto corner = [&points](std::int64_t index) -> const NumberPoint& {
    // A negative index hides the edge that starts there.
    const auto count = static_cast<std::int64_t>(points.size());
    if (index < -count || index > count) {
      throw Unusable{"face with a vertex that is not there", std::to_string(index)};
    }
    return points[static_cast<std::size_t>(std::abs(index)) - 1];
  };
  for (auto i = face.face.begin(); i != end; ++i) {
    const auto next = i + 1 == end ? face.face.begin() : i + 1;
    if (*i < 0 && !draws_hidden) {
      drawn.refused.push_back({"hidden edge", {}, true});
    } else {
      const NumberPoint& from = corner(*i);
      drawn.segments.push_back(from, corner(*next));
    }
  }
}

DrawnEntity draw_polyface(const Polyline& mesh, bool draws_hidden) {
  std::vector<NumberPoint> points;
  for (const PolylineVertex& vertex : mesh.vertices) {
    if (has(vertex.flags, kMeshVertex)) points.push_back(vertex.point);
  }
  DrawnEntity drawn;
  for (const PolylineVertex& vertex : mesh.vertices) {
    if (has(vertex.flags, kMeshVertex) || !has(vertex.flags, kFaceVertex)) continue;
    try {
      draw_polyface_face(vertex, points, draws_hidden, drawn);
    } catch (const Unusable& problem) {
      drawn.refused.push_back(problem);
    }
  }
  return drawn;
}

}  // namespace

Polyline polyline_of(const Entity& entity) {
  Polyline polyline;
  polyline.flags = entity.integer(70, 0);
  polyline.smoothing = entity.integer(75, 0);
  polyline.rows = entity.integer(71, 0);
  polyline.columns = entity.integer(72, 0);
  if (!has(polyline.flags, kInSpace | kMesh | kPolyface)) polyline.plane = plane_of(entity);
  return polyline;
}

PolylineVertex polyline_vertex_of(const Entity& entity) {
  PolylineVertex vertex;
  vertex.flags = entity.integer(70, 0);
  const bool is_face = has(vertex.flags, kFaceVertex) && !has(vertex.flags, kMeshVertex);
  if (!is_face) vertex.point = entity.point(10);
  vertex.bulge = entity.number(42, {});
  for (std::size_t i = 0; i < vertex.face.size(); ++i) {
    constexpr int kFirstCorner = 71;
    vertex.face[i] = entity.integer(kFirstCorner + static_cast<int>(i), 0);
  }
  return vertex;
}

DrawnEntity draw_polyline(const Polyline& polyline, Pen& pen) {
  if (has(polyline.flags, kPolyface)) return draw_polyface(polyline, pen.draws_hidden);
  if (has(polyline.flags, kMesh)) return draw_mesh(polyline);
  std::vector<Vertex> vertices;
  std::vector<Unusable> frame;
  for (const PolylineVertex& vertex : polyline.vertices) {
    if (has(polyline.flags, kSplineFit) && has(vertex.flags, kFrameVertex)) {
      frame.push_back({"vertex of the frame of a fitted curve", {}, true});
    } else {
      vertices.push_back({vertex.point, has(polyline.flags, kInSpace) ? Number() : vertex.bulge});
    }
  }
  DrawnEntity drawn = draw_polyline(vertices, has(polyline.flags, kClosed), polyline.plane, pen);
  drawn.refused.insert(drawn.refused.end(), frame.begin(), frame.end());
  return drawn;
}

DrawnEntity draw_polyline(const std::vector<Vertex>& vertices, bool closed, Plane plane, Pen& pen) {
  if (vertices.size() < 2) throw Unusable{"polyline of fewer than two vertices", {}, true};
  DrawnEntity drawn;
  double bound = 0;
  bool has_arc = false;
  const auto draw = [&](const Vertex& from, const Vertex& to) {
    std::vector<NumberPoint> points{from.point, to.point};
    if (sgn(from.bulge) != 0 && from.point != to.point) {
      const Point a{from.point.x.rational(), from.point.y.rational()};
      const Point b{to.point.x.rational(), to.point.y.rational()};
      EllipticArc arc = bulge_arc(a, b, from.bulge.rational());
      Chords chords = pen.arc(arc);
      bound = std::max(bound, chords.bound);
      has_arc = true;
      const double at_a = text_rounding(from.point), at_b = text_rounding(to.point);
      const double rounding =
          at_a + at_b + half_unit(from.bulge) * distance(nearest(a), nearest(b));
      const std::array<double, 2> roundings{at_a > 0 ? rounding : 0, at_b > 0 ? rounding : 0};
      if (plane == Plane::Back) {
        mirror_x(chords.points);
        mirror_x(arc.ellipse);
      }
      append_curve(drawn, chords.points,
                   {0, 0, std::move(arc.ellipse), chords.bound, roundings, rounding});
      return;
    }
    if (plane == Plane::Back) mirror_x(points);
    append_chain(drawn.segments, points);
  };
  for (std::size_t i = 1; i < vertices.size(); ++i) draw(vertices[i - 1], vertices[i]);
  if (closed && vertices.back().point != vertices.front().point) {
    draw(vertices.back(), vertices.front());
  }
  if (closed && !has_arc) end_ring(drawn, 0);
  if (has_arc) drawn.replaced.push_back(by_chords("bulge", bound));
  return drawn;
}

}  // namespace plumbline::dxf
