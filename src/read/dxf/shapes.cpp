// The entities that one record describes, without the splines.

#include "read/dxf/shapes.hpp"

#include <algorithm>
#include <array>

#include "read/dxf/curves.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kFirstZ = 30;
constexpr int kLastZ = 33;
constexpr int kElevation = 38;

DrawnEntity draw_line(const Entity& entity, Pen& /*pen*/) {
  DrawnEntity drawn;
  drawn.segments.push_back(entity.point(10), entity.point(11));
  return drawn;
}

DrawnEntity draw_lwpolyline(const Entity& entity, Pen& pen) {
  constexpr int kX = 10;
  constexpr int kY = 20;
  constexpr int kBulge = 42;
  std::vector<Vertex> vertices;
  bool has_y = true;
  const auto check = [&has_y] {
    if (!has_y) throw Unusable{"vertex without group 20", {}};
  };
  for (const Group& group : entity.record().groups) {
    if (group.code == kX) {
      check();
      vertices.push_back({{number_of(group, entity.numbers()), {}}, {}});
      has_y = false;
    } else if (group.code == kY && !vertices.empty()) {
      vertices.back().point.y = number_of(group, entity.numbers());
      has_y = true;
    } else if (group.code == kBulge && !vertices.empty()) {
      vertices.back().bulge = number_of(group, entity.numbers());
    }
  }
  check();
  const bool closed = (entity.integer(kFlags, 0) & kClosed) != 0;
  return draw_polyline(vertices, closed, plane_of(entity), pen);
}

/// The corners from groups 10, 11, 12 and 13; three where the last is missing or the third again.
std::vector<NumberPoint> corners(const Entity& entity) {
  std::vector<NumberPoint> points{entity.point(10), entity.point(11), entity.point(12)};
  constexpr int kFourth = 13;
  if (!entity.has(kFourth)) return points;
  NumberPoint fourth = entity.point(kFourth);
  // Corners differ where they do in height only.
  const Number zero;
  if (fourth != points[2] || entity.number(kLastZ, zero) != entity.number(kLastZ - 1, zero)) {
    points.push_back(std::move(fourth));
  }
  return points;
}

DrawnEntity draw_face(const Entity& entity, Pen& pen) {
  const std::vector<NumberPoint> points = corners(entity);
  const auto hidden = static_cast<std::uint64_t>(entity.integer(kFlags, 0));
  DrawnEntity drawn;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!pen.draws_hidden && ((hidden >> i) & 1U) != 0) {
      drawn.refused.push_back({"hidden edge", {}, true});
    } else {
      drawn.segments.push_back(points[i], points[(i + 1) % points.size()]);
    }
  }
  if (drawn.refused.empty()) end_ring(drawn, 0);
  return drawn;
}

DrawnEntity draw_solid(const Entity& entity, Pen& /*pen*/) {
  std::vector<NumberPoint> points = corners(entity);
  if (points.size() == 4) std::swap(points[2], points[3]);  // they come in the shape of a Z
  if (plane_of(entity) == Plane::Back) mirror_x(points);
  DrawnEntity drawn;
  append_ring(drawn, points);
  return drawn;
}

struct Shape {
  std::string_view type;
  DrawnEntity (*draw)(const Entity&, Pen&);
};
constexpr std::array kShapes{
    Shape{"LINE", draw_line},       Shape{"LWPOLYLINE", draw_lwpolyline},
    Shape{"ARC", draw_arc},         Shape{"CIRCLE", draw_circle},
    Shape{"ELLIPSE", draw_ellipse}, Shape{"SPLINE", draw_spline},
    Shape{"3DFACE", draw_face},     Shape{"SOLID", draw_solid},
    Shape{"TRACE", draw_solid},
};

const Shape* shape_of(std::string_view type) {
  const auto* found = std::find_if(kShapes.begin(), kShapes.end(),
                                   [type](const Shape& shape) { return shape.type == type; });
  return found == kShapes.end() ? nullptr : found;
}

}  // namespace

bool is_shape(std::string_view type) { return shape_of(type) != nullptr; }

DrawnEntity draw_shape(const Entity& entity, Pen& pen) {
  return shape_of(entity.record().type)->draw(entity, pen);
}

bool has_height(const Entity& entity) {
  const auto& groups = entity.record().groups;
  return std::any_of(groups.begin(), groups.end(), [&entity](const Group& group) {
    const bool is_z = (kFirstZ <= group.code && group.code <= kLastZ) || group.code == kElevation;
    return is_z && sgn(number_of(group, entity.numbers())) != 0;
  });
}

}  // namespace plumbline::dxf
