// Draws a complex as SVG elements: faces below, then edges, then what is marked.

#include "output/svg/panel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::svg {
namespace {

constexpr double kMarkPens = 2.5, kDashPens = 4, kDotPens = 2;

PointD place(const FloatComplex& complex, VertexId v) { return complex.vertices[v]; }
PointD place(const ExactComplex& complex, VertexId v) { return complex.vertices.nearest(v); }

template <class Complex>
std::string cycle_path(const Complex& complex, CycleId cycle, const Frame& frame) {
  std::vector<PointD> points;
  points.reserve(complex.cycles[cycle].size());
  for (const HalfedgeId h : complex.cycles[cycle]) {
    points.push_back(frame(place(complex, complex.origin(h))));
  }
  return closed_path(points);
}

template <class Complex>
std::string path_of(const Complex& complex, FaceId f, const Frame& frame) {
  std::string path;
  if (complex.face_outer[f].valid()) path = cycle_path(complex, complex.face_outer[f], frame);
  for (const CycleId hole : complex.face_holes[f]) path += cycle_path(complex, hole, frame);
  return path;
}

void append_faces(std::string& svg, const FloatComplex& complex, const Frame& frame) {
  svg += "<g stroke=\"none\" fill-rule=\"evenodd\">\n";
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const std::size_t depth = std::max<std::size_t>(complex.face_depth[f], 1);
    svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n",
                       kDepthColours[std::min(depth, kDepthColours.size()) - 1],
                       path_of(complex, FaceId(f), frame));
  }
  svg += "</g>\n";
}

void append_line(std::string& path, const FloatComplex& complex, EdgeId e, const Frame& frame) {
  const Edge& edge = complex.edges[e];
  path += fmt::format("M{}L{}", coordinates(frame(complex.vertices[edge.tail])),
                      coordinates(frame(complex.vertices[edge.head])));
}

void append_edges(std::string& svg, const FloatComplex& complex, const Frame& frame, double pen,
                  const std::string& more) {
  const std::string style =
      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"{}",
                  kInk, shortest_text(pen), more);
  const std::string dashes =
      fmt::format(" stroke-dasharray=\"{}\"", shortest_text(kDashPens * pen));
  for (const bool dashed : {false, true}) {
    std::string path;
    const auto draw = [&] {
      if (path.empty()) return;
      svg += fmt::format("<path {}{} d=\"{}\"/>\n", style, dashed ? dashes : "", path);
      path.clear();
    };
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      if (complex.is_antenna(EdgeId(e)) == dashed) append_line(path, complex, EdgeId(e), frame);
      if (path.size() > kLargestPath) draw();
    }
    draw();
  }
}

std::string dot(const PointD& p, double pen, const char* colour) {
  return circle(p, kDotPens * pen, fmt::format(" fill=\"{}\"", colour));
}

void append_marked_faces(std::string& svg, const FloatComplex& complex, const Frame& frame,
                         const Marks& marks) {
  for (const FaceId f : marks.faces) {
    if (f == kUnbounded) continue;
    svg += fmt::format("<path fill=\"{}\" fill-opacity=\"0.28\" fill-rule=\"evenodd\" ", kMark);
    svg += fmt::format("d=\"{}\"/>\n", path_of(complex, f, frame));
  }
}

void append_marked_edges(std::string& svg, const FloatComplex& complex, const Frame& frame,
                         double pen, const Marks& marks) {
  std::string path;
  for (const EdgeId e : marks.edges) append_line(path, complex, e, frame);
  if (path.empty()) return;
  svg += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" ", kMark,
                     shortest_text(kMarkPens * pen));
  svg += fmt::format("stroke-linecap=\"round\" d=\"{}\"/>\n", path);
}

}  // namespace

std::string panel(const FloatComplex& complex, const Frame& frame, double pen, const Marks& marks,
                  const std::string& of_lines) {
  std::string svg;
  append_faces(svg, complex, frame);
  append_marked_faces(svg, complex, frame, marks);
  append_edges(svg, complex, frame, pen, of_lines);
  append_marked_edges(svg, complex, frame, pen, marks);
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    for (const VertexId v : complex.face_isolated_vertices[f]) {
      svg += dot(frame(complex.vertices[v]), pen, kInk);
    }
  }
  for (const VertexId v : marks.vertices) svg += dot(frame(complex.vertices[v]), pen, kMark);
  return svg;
}

std::string face_path(const ExactComplex& complex, FaceId f, const Frame& frame) {
  return path_of(complex, f, frame);
}

std::string edge_paths(const ExactComplex& complex, const Frame& frame, double pen) {
  constexpr std::size_t kPieces = 5000;  // edges of a path
  std::string text;
  for (std::size_t first = 0; first < complex.edge_count(); first += kPieces) {
    text += fmt::format(
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linecap=\"round\" d=\"",
        kInk, shortest_text(pen));
    for (std::size_t e = first; e < std::min(first + kPieces, complex.edge_count()); ++e) {
      const auto [tail, head] = complex.edges[e];
      text += fmt::format("M{}L{}", coordinates(frame(complex.vertices.nearest(tail))),
                          coordinates(frame(complex.vertices.nearest(head))));
    }
    text += "\"/>\n";
  }
  return text;
}

}  // namespace plumbline::svg
