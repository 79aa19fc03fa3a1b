// Draws a complex as SVG elements: faces below, then edges, then what is marked.

#include "output/svg/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plumbline::svg {
namespace {

// A smaller drawing is drawn as a point: magnifying it to a panel would overflow.
constexpr double kLeastExtent = 1e-290;
// A picture of this many pens across reads well on a screen: thin lines at 1600 pixels.
constexpr double kPensAcross = 1000;
constexpr double kMarkPens = 2.5, kDashPens = 4, kDotPens = 2;

using Out = std::back_insert_iterator<std::string>;

void append_cycle(std::string& path, const FloatComplex& complex, CycleId cycle,
                  const Frame& frame) {
  char command = 'M';
  for (const HalfedgeId h : complex.cycles[cycle]) {
    path += command;
    path += coordinates(frame(complex.vertices[complex.origin(h)]));
    command = 'L';
  }
  if (command == 'L') path += 'Z';
}

std::string face_path(const FloatComplex& complex, FaceId f, const Frame& frame) {
  std::string path;
  if (complex.face_outer[f].valid()) append_cycle(path, complex, complex.face_outer[f], frame);
  for (const CycleId hole : complex.face_holes[f]) append_cycle(path, complex, hole, frame);
  return path;
}

void append_faces(std::string& svg, const FloatComplex& complex, const Frame& frame) {
  svg += "<g stroke=\"none\" fill-rule=\"evenodd\">\n";
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const std::size_t depth = std::max<std::size_t>(complex.face_depth[f], 1);
    fmt::format_to(Out(svg), "<path fill=\"{}\" d=\"{}\"/>\n",
                   kDepthColours[std::min(depth, kDepthColours.size()) - 1],
                   face_path(complex, FaceId(f), frame));
  }
  svg += "</g>\n";
}

void append_line(std::string& path, const FloatComplex& complex, EdgeId e, const Frame& frame) {
  const Edge& edge = complex.edges[e];
  fmt::format_to(Out(path), "M{}L{}", coordinates(frame(complex.vertices[edge.tail])),
                 coordinates(frame(complex.vertices[edge.head])));
}

void append_edges(std::string& svg, const FloatComplex& complex, const Frame& frame, double pen) {
  std::string solid, dashed;
  for (std::size_t e = 0; e < complex.edge_count(); ++e)
    append_line(complex.is_antenna(EdgeId(e)) ? dashed : solid, complex, EdgeId(e), frame);
  const std::string style =
      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"", kInk,
                  shortest_text(pen));
  if (!solid.empty()) fmt::format_to(Out(svg), "<path {} d=\"{}\"/>\n", style, solid);
  if (!dashed.empty())
    fmt::format_to(Out(svg), "<path {} stroke-dasharray=\"{}\" d=\"{}\"/>\n", style,
                   shortest_text(kDashPens * pen), dashed);
}

void append_dot(std::string& svg, const PointD& p, double radius, const char* colour) {
  fmt::format_to(Out(svg), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n",
                 shortest_text(p.x), shortest_text(p.y), shortest_text(radius), colour);
}

void append_marked_faces(std::string& svg, const FloatComplex& complex, const Frame& frame,
                         const Marks& marks) {
  for (const FaceId f : marks.faces) {
    if (f == kUnbounded) continue;
    fmt::format_to(Out(svg), "<path fill=\"{}\" fill-opacity=\"0.28\" fill-rule=\"evenodd\" ",
                   kMark);
    fmt::format_to(Out(svg), "d=\"{}\"/>\n", face_path(complex, f, frame));
  }
}

void append_marked_edges(std::string& svg, const FloatComplex& complex, const Frame& frame,
                         double pen, const Marks& marks) {
  std::string path;
  for (const EdgeId e : marks.edges) append_line(path, complex, e, frame);
  if (path.empty()) return;
  fmt::format_to(Out(svg), "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" ", kMark,
                 shortest_text(kMarkPens * pen));
  fmt::format_to(Out(svg), "stroke-linecap=\"round\" d=\"{}\"/>\n", path);
}

double rounded(double value, double steps) {
  return steps == 0 ? value : std::round(value * steps) / steps;
}

}  // namespace

Box hull(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

Box bounds(const FloatComplex& complex) {
  if (complex.vertices.empty()) return {{0, 0}, {1, 1}};
  Box box{complex.vertices[0], complex.vertices[0]};
  for (const PointD& p : complex.vertices) box = hull(box, {p, p});
  if (std::max(box.width(), box.height()) > kLeastExtent) return box;
  return {{box.low.x - 0.5, box.low.y - 0.5}, {box.high.x + 0.5, box.high.y + 0.5}};
}

Box widened(const Box& box, double fraction) {
  const double margin = fraction * std::max(box.width(), box.height());
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

PointD Frame::operator()(const PointD& p) const {
  return {rounded((p.x - origin.x) * scale + place.x, steps),
          rounded((y_up ? origin.y - p.y : p.y - origin.y) * scale + place.y, steps)};
}

Frame fit(const Box& content, const Box& panel, bool y_up) {
  const double scale = std::min(panel.width() / content.width(), panel.height() / content.height());
  return {{content.low.x, y_up ? content.high.y : content.low.y},
          {panel.low.x + (panel.width() - content.width() * scale) / 2,
           panel.low.y + (panel.height() - content.height() * scale) / 2},
          scale,
          0,
          y_up};
}

std::string coordinates(const PointD& p) { return shortest_text(p.x) + ' ' + shortest_text(p.y); }

double pen_width(const Box& box) { return std::max(box.width(), box.height()) / kPensAcross; }

std::string panel(const FloatComplex& complex, const Frame& frame, double pen, const Marks& marks) {
  std::string svg;
  append_faces(svg, complex, frame);
  append_marked_faces(svg, complex, frame, marks);
  append_edges(svg, complex, frame, pen);
  append_marked_edges(svg, complex, frame, pen, marks);
  for (std::size_t f = 0; f < complex.face_count(); ++f)
    for (const VertexId v : complex.face_isolated_vertices[f])
      append_dot(svg, frame(complex.vertices[v]), kDotPens * pen, kInk);
  for (const VertexId v : marks.vertices)
    append_dot(svg, frame(complex.vertices[v]), kDotPens * pen, kMark);
  return svg;
}

}  // namespace plumbline::svg
