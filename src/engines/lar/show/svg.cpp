// Pictures of the float pipeline, as in the publication: buckets and components in colours, faces,
// faces pulled apart, numbered cells, merged vertices, filled faces, single polylines, boundaries.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engines/lar/show/canvas.hpp"
#include "engines/lar/show/solid.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline {
namespace {

using svg::Canvas;
using svg::LarScene;

svg::Box box_of(const LarScene& scene) {
  FloatComplex complex;
  for (const LarScene::Line& line : scene.lines) {
    complex.vertices.push_back(line.a);
    complex.vertices.push_back(line.b);
  }
  complex.vertices.insert(complex.vertices.end(), scene.vertices.begin(), scene.vertices.end());
  return svg::bounds(complex);
}

/// Middle of the outer boundary's box.
PointD middle(const LarScene::Polygon& face) {
  FloatComplex complex;
  complex.vertices = face.front();
  const svg::Box box = svg::bounds(complex);
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
}

PointD middle(const PointD& p, const PointD& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

std::string stroke(const std::string& ink) { return " stroke=\"" + ink + '"'; }

/// A size of numbers at which so many of them can be told apart.
double number_size(std::size_t cells) {
  constexpr double kLargest = 16, kShare = 0.2;
  return std::min(kLargest, kShare * Canvas::kSide / std::sqrt(static_cast<double>(cells + 1)));
}

void buckets(const LarScene& scene, Canvas& canvas) {
  for (const LarScene::Line& l : scene.lines) {
    canvas.line(l.a, l.b, stroke(svg::colour(l.bucket)));
  }
}

void edges(const LarScene& scene, std::span<const std::array<VertexId, 2>> pairs, Canvas& canvas,
           const std::string& attributes = {}) {
  for (const auto& [v, w] : pairs) {
    canvas.line(scene.vertices[v], scene.vertices[w], attributes);
  }
}

void components(const LarScene& scene, Canvas& canvas) {
  for (std::size_t c = 0; c < scene.components.size(); ++c) {
    edges(scene, scene.components[c], canvas, stroke(svg::colour(c)) + " stroke-width=\"2\"");
  }
  edges(scene, scene.bridges, canvas, " stroke-dasharray=\"4\"");
}

void faces(std::span<const LarScene::Polygon> polygons, Canvas& canvas) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.paths(polygons[f], fmt::format(" fill=\"{}\" fill-opacity=\"0.5\"", svg::colour(f)));
  }
}

/// The faces, each moved away from the drawing's corner by the factor.
void exploded(const LarScene& scene, double factor, Canvas& canvas) {
  const svg::Box box = canvas.box();
  canvas.show({box.low, {box.low.x + box.width() * factor, box.low.y + box.height() * factor}});
  std::vector<LarScene::Polygon> moved = scene.faces;
  for (LarScene::Polygon& face : moved) {
    const PointD from = middle(face);
    const PointD shift{(factor - 1) * (from.x - box.low.x), (factor - 1) * (from.y - box.low.y)};
    for (std::vector<PointD>& cycle : face)
      for (PointD& p : cycle) p = {p.x + shift.x, p.y + shift.y};
  }
  faces(moved, canvas);
}

void numbers_of(std::span<const LarScene::Polygon> polygons, double size, Canvas& canvas) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.text(middle(polygons[f]), f, 1.5 * size, svg::kMark);
  }
}

constexpr const char* kTexts = " stroke=\"none\" font-family=\"sans-serif\" text-anchor=\"middle\"";

void numbers(const LarScene& scene, Canvas& canvas) {
  constexpr const char* kEdgeInk = "#5a6b7a";
  const double size = number_size(scene.edges.size());
  faces(scene.faces, canvas);
  edges(scene, scene.edges, canvas);
  canvas.open_group(kTexts);
  numbers_of(scene.faces, size, canvas);
  for (std::size_t e = 0; e < scene.edges.size(); ++e) {
    const auto& [v, w] = scene.edges[e];
    canvas.text(middle(scene.vertices[v], scene.vertices[w]), e, size, kEdgeInk);
  }
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    canvas.text(scene.vertices[v], v, size, svg::kInk);
  }
  canvas.close_group();
}

void pruning(const LarScene& scene, Canvas& canvas) {
  constexpr double kDot = 1.5;
  const auto filled = [](const char* ink) {
    return fmt::format(" fill=\"{}\" stroke=\"none\"", ink);
  };
  for (const LarScene::Line& l : scene.lines) canvas.line(l.a, l.b, " stroke-opacity=\"0.3\"");
  for (const PointD& p : scene.unpruned) canvas.circle(p, kDot, filled(svg::kInk));
  for (std::size_t c = 0; c < scene.clusters.size(); ++c) {
    for (const VertexId v : scene.clusters[c]) {
      const PointD& p = scene.unpruned[v];
      canvas.circle(p, std::max(canvas.length(scene.radius), 2 * kDot), " stroke-width=\"0.5\"");
      canvas.line(p, scene.centroids[c], stroke(svg::kMark));
    }
    canvas.circle(scene.centroids[c], kDot, filled(svg::kMark));
  }
}

/// Triangles in the colours of their faces; edges that could not be filled in the second colour.
void filled(std::span<const LarScene::Polygon> polygons,
            std::span<const std::vector<svg::TriangleD>> fillings, Canvas& canvas) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    const std::string ink = svg::colour(f);
    canvas.open_group(fmt::format(" fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.3\"", ink));
    for (const svg::TriangleD& t : fillings[f]) {
      canvas.paths({{{t.begin(), t.end()}}}, {});
    }
    canvas.close_group();
  }
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.paths(polygons[f], fillings[f].empty() ? stroke(svg::kMark) : std::string());
  }
}

void polylines(std::span<const svg::Bridged> faces, Canvas& canvas) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    canvas.paths(faces[f].polylines,
                 fmt::format(" fill=\"{}\" fill-opacity=\"0.3\"", svg::colour(f)));
  }
  for (const svg::Bridged& face : faces)
    for (const auto& [p, q] : face.bridges) {
      canvas.line(p, q, stroke(svg::kMark) + " stroke-width=\"2\"");
    }
}

/// Chosen faces filled, their boundary as chain in the second colour, all faces numbered.
void boundary(const LarScene& scene, std::span<const LarScene::Polygon> polygons,
              std::span<const std::size_t> chosen,
              std::span<const std::array<PointD, 2>> boundary_edges, Canvas& canvas) {
  for (const std::size_t f : chosen) {
    canvas.paths(polygons[f], fmt::format(" fill=\"{}\" stroke=\"none\"", svg::kDepthColours[1]));
  }
  edges(scene, scene.edges, canvas);
  for (const auto& [p, q] : boundary_edges) {
    canvas.line(p, q, stroke(svg::kMark) + " stroke-width=\"3\"");
  }
  canvas.open_group(kTexts);
  numbers_of(polygons, number_size(polygons.size()), canvas);
  canvas.close_group();
}

void check(const LarPicture& options) {
  if (std::isfinite(options.explode) && options.explode >= 1) return;
  throw Error(ErrorCode::BadInput, "the factor of an exploded view must be 1 or more", {},
              shortest_text(options.explode));
}

template <class Result>
void draw(const Result& result, const LarPicture& options, const LarScene& scene, Canvas& canvas) {
  switch (options.show) {
    case LarShow::Buckets:
      return buckets(scene, canvas);
    case LarShow::Components:
      return components(scene, canvas);
    case LarShow::Faces:
      faces(scene.faces, canvas);
      return edges(scene, scene.edges, canvas);
    case LarShow::Explode:
      return exploded(scene, options.explode, canvas);
    case LarShow::Numbers:
      return numbers(scene, canvas);
    case LarShow::Pruning:
      return pruning(scene, canvas);
    case LarShow::Filled:
      return filled(svg::solid_faces(result), svg::fillings(result), canvas);
    case LarShow::Polylines:
      return polylines(svg::bridged(result), canvas);
    case LarShow::Boundary: {
      const std::vector<LarScene::Polygon> polygons = svg::solid_faces(result);
      std::vector<std::size_t> chosen = options.faces;
      if (chosen.empty()) {
        chosen.resize(polygons.size());
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
      }
      const auto found = svg::boundary(result, chosen);
      return boundary(scene, polygons, chosen, found, canvas);
    }
  }
}

template <class Result>
std::string picture_of(const Result& result, const LarPicture& options) {
  check(options);
  const LarScene scene = svg::scene(result);
  Canvas canvas(box_of(scene), options.y_up);
  draw(result, options, scene, canvas);
  return canvas.svg();
}

}  // namespace

std::string to_svg(const lar::Result& result, const LarPicture& options) {
  return picture_of(result, options);
}

std::string to_svg(const inters::Trace& trace, const LarPicture& options) {
  return picture_of(trace, options);
}

}  // namespace plumbline
