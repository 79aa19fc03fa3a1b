// A part of a complex, magnified without limit: what is shown is cut out in exact numbers before
// these become pixels.

#include "output/svg/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace plumbline::svg {
namespace {

constexpr double kPen = 1.2, kMarkedPen = 3.5, kDot = 3, kMarkedDot = 5;
constexpr double kSteps = 100;  // of a pixel

/// The exact window, and its map to pixels.
class View {
 public:
  View(const Window& window, const Box& panel, bool y_up)
      : panel_(panel),
        y_up_(y_up),
        low_{window.centre.x - window.across / 2,
             window.centre.y - window.across * Rational(panel.height() / panel.width()) / 2},
        high_{2 * window.centre.x - low_.x, 2 * window.centre.y - low_.y} {}

  /// A linear function that is positive within one of the four sides.
  Rational within(const Point& p, int side) const {
    if (side == 0) return p.x - low_.x;
    if (side == 1) return high_.x - p.x;
    return side == 2 ? Rational(p.y - low_.y) : Rational(high_.y - p.y);
  }
  bool holds(const Point& p) const {
    for (int side = 0; side < 4; ++side) {
      if (sgn(within(p, side)) < 0) return false;
    }
    return true;
  }
  PointD pixel(const Point& p) const {
    const Rational x = (p.x - low_.x) / (high_.x - low_.x);
    const Rational y = (p.y - low_.y) / (high_.y - low_.y);
    const double down = y_up_ ? 1 - y.get_d() : y.get_d();
    return {std::round((panel_.low.x + x.get_d() * panel_.width()) * kSteps) / kSteps,
            std::round((panel_.low.y + down * panel_.height()) * kSteps) / kSteps};
  }

 private:
  Box panel_;
  bool y_up_;
  Point low_, high_;
};

/// Where pq meets a side of which the two are on different sides.
Point crossing(const Point& p, const Point& q, const Rational& at_p, const Rational& at_q) {
  const Rational t = at_p / (at_p - at_q);
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

std::optional<Segment> clipped(Segment s, const View& view) {
  for (int side = 0; side < 4; ++side) {
    const Rational at_a = view.within(s.a, side), at_b = view.within(s.b, side);
    if (sgn(at_a) < 0 && sgn(at_b) < 0) return std::nullopt;
    if (sgn(at_a) < 0) s.a = crossing(s.a, s.b, at_a, at_b);
    if (sgn(at_b) < 0) s.b = crossing(s.a, s.b, at_a, at_b);
  }
  return s;
}

/// A polygon, side by side (Sutherland and Hodgman 1974).
std::vector<Point> clipped(std::vector<Point> polygon, const View& view) {
  for (int side = 0; side < 4; ++side) {
    std::vector<Point> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& p = polygon[i];
      const Point& q = polygon[(i + 1) % polygon.size()];
      const Rational at_p = view.within(p, side), at_q = view.within(q, side);
      if (sgn(at_p) >= 0) result.push_back(p);
      if (sgn(at_p) * sgn(at_q) < 0) result.push_back(crossing(p, q, at_p, at_q));
    }
    polygon = std::move(result);
  }
  return polygon;
}

std::string path_of(const ExactComplex& complex, FaceId f, const View& view) {
  std::vector<CycleId> cycles(complex.face_holes[f].begin(), complex.face_holes[f].end());
  if (complex.face_outer[f].valid()) cycles.push_back(complex.face_outer[f]);
  std::string path;
  for (const CycleId cycle : cycles) {
    std::vector<Point> corners;
    for (const HalfedgeId h : complex.cycles[cycle]) {
      corners.push_back(complex.vertices[complex.origin(h)]);
    }
    std::vector<PointD> pixels;
    for (const Point& p : clipped(std::move(corners), view)) pixels.push_back(view.pixel(p));
    path += closed_path(pixels);
  }
  return path;
}

std::string drawn_face(const ExactComplex& complex, FaceId f, const View& view,
                       const std::string& fill) {
  const std::string path = path_of(complex, f, view);
  if (path.empty()) return path;
  return fmt::format("<path fill-rule=\"evenodd\" {} d=\"{}\"/>\n", fill, path);
}

std::string drawn_edge(const ExactComplex& complex, EdgeId e, const View& view,
                       const std::string& pen) {
  const auto [tail, head] = complex.edges[e];
  const auto seen = clipped(Segment{complex.vertices[tail], complex.vertices[head]}, view);
  if (!seen) return {};
  return fmt::format("<path fill=\"none\" {} d=\"M{}L{}\"/>\n", pen,
                     coordinates(view.pixel(seen->a)), coordinates(view.pixel(seen->b)));
}

std::string drawn_vertex(const ExactComplex& complex, VertexId v, const View& view, double radius,
                         const char* colour) {
  const Point p = complex.vertices[v];
  if (!view.holds(p)) return {};
  return circle(view.pixel(p), radius, fmt::format(" fill=\"{}\"", colour));
}

std::string pen(const char* colour, double width) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"", colour, width);
}

}  // namespace

Window window_around(const PointList& vertices, const Box& panel) {
  if (vertices.empty()) return {{0, 0}, 1};
  Point low = vertices.front(), high = low;
  for (const Point& p : vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Rational room = Rational(11, 10);
  const Rational shape(panel.width() / panel.height());
  const Rational across = room * std::max<Rational>(high.x - low.x, (high.y - low.y) * shape);
  return {{(low.x + high.x) / 2, (low.y + high.y) / 2}, sgn(across) > 0 ? across : Rational(1)};
}

std::string in_window(const ExactComplex& complex, const Window& window, const Box& panel,
                      bool y_up, const Marks& marks) {
  const View view(window, panel, y_up);
  std::string svg;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const std::size_t depth = std::max<std::size_t>(complex.face_depth[f], 1);
    svg += drawn_face(
        complex, FaceId(f), view,
        fmt::format("fill=\"{}\"", kDepthColours[std::min(depth, kDepthColours.size()) - 1]));
  }
  for (const FaceId f : marks.faces) {
    if (f == kUnbounded) continue;
    svg += drawn_face(complex, f, view, fmt::format("fill=\"{}\" fill-opacity=\"0.28\"", kMark));
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    svg += drawn_edge(complex, EdgeId(e), view, pen(kInk, kPen));
  }
  for (const EdgeId e : marks.edges) svg += drawn_edge(complex, e, view, pen(kMark, kMarkedPen));
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    svg += drawn_vertex(complex, VertexId(v), view, kDot, kInk);
  }
  for (const VertexId v : marks.vertices) {
    svg += drawn_vertex(complex, v, view, kMarkedDot, kMark);
  }
  return svg;
}

}  // namespace plumbline::svg
