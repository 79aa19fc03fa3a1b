// Pictures of the float pipeline, as in the publication: buckets and components in colours, faces,
// faces pulled apart, numbered cells, merged vertices, filled faces, single polylines, boundaries.

#include "engines/lar/show/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engines/lar/show/canvas.hpp"
#include "plumbline/error.hpp"

namespace plumbline::svg {
namespace {

Box box_of(const Scene& scene) {
  std::vector<PointD> points = scene.vertices;
  for (const Scene::Line& line : scene.lines) {
    points.push_back(line.a);
    points.push_back(line.b);
  }
  return bounds(points);
}

/// Middle of the outer boundary's box.
PointD middle(const Scene::Polygon& face) {
  const Box box = bounds(face.front());
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
}

PointD middle(const PointD& p, const PointD& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

std::string stroke(const std::string& ink) { return " stroke=\"" + ink + '"'; }

/// A size of numbers at which so many of them can be told apart.
double number_size(std::size_t cells) {
  constexpr double kLargest = 16, kShare = 0.2;
  return std::min(kLargest, kShare * Canvas::kSide / std::sqrt(static_cast<double>(cells + 1)));
}

void buckets(const Scene& scene, Canvas& canvas) {
  for (const Scene::Line& l : scene.lines) {
    canvas.line(l.a, l.b, stroke(colour(l.bucket)));
  }
}

void edges(const Scene& scene, std::span<const std::array<VertexId, 2>> pairs, Canvas& canvas,
           const std::string& attributes = {}) {
  for (const auto& [v, w] : pairs) {
    canvas.line(scene.vertices[v], scene.vertices[w], attributes);
  }
}

void components(const Scene& scene, Canvas& canvas) {
  for (std::size_t c = 0; c < scene.components.size(); ++c) {
    edges(scene, scene.components[c], canvas, stroke(colour(c)) + " stroke-width=\"2\"");
  }
  edges(scene, scene.bridges, canvas, " stroke-dasharray=\"4\"");
}

void faces(std::span<const Scene::Polygon> polygons, Canvas& canvas) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.paths(polygons[f], fmt::format(" fill=\"{}\" fill-opacity=\"0.5\"", colour(f)));
  }
}

/// The faces, each moved away from the drawing's corner by the factor.
void exploded(const Scene& scene, double factor, Canvas& canvas) {
  const Box box = canvas.box();
  canvas.show({box.low, {box.low.x + box.width() * factor, box.low.y + box.height() * factor}});
  std::vector<Scene::Polygon> moved = scene.faces;
  for (Scene::Polygon& face : moved) {
    const PointD from = middle(face);
    const PointD shift{(factor - 1) * (from.x - box.low.x), (factor - 1) * (from.y - box.low.y)};
    for (std::vector<PointD>& cycle : face) {
      for (PointD& p : cycle) p = {p.x + shift.x, p.y + shift.y};
    }
  }
  faces(moved, canvas);
}

void numbers_of(std::span<const Scene::Polygon> polygons, double size, Canvas& canvas) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.text(middle(polygons[f]), f, 1.5 * size, kMark);
  }
}

constexpr const char* kTexts = " stroke=\"none\" font-family=\"sans-serif\" text-anchor=\"middle\"";

void numbers(const Scene& scene, Canvas& canvas) {
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
    canvas.text(scene.vertices[v], v, size, kInk);
  }
  canvas.close_group();
}

void pruning(const Scene& scene, Canvas& canvas) {
  constexpr double kDot = 1.5;
  const auto filled = [](const char* ink) {
    return fmt::format(" fill=\"{}\" stroke=\"none\"", ink);
  };
  for (const Scene::Line& l : scene.lines) canvas.line(l.a, l.b, " stroke-opacity=\"0.3\"");
  for (const PointD& p : scene.unpruned) canvas.circle(p, kDot, filled(kInk));
  for (std::size_t c = 0; c < scene.clusters.size(); ++c) {
    for (const VertexId v : scene.clusters[c]) {
      const PointD& p = scene.unpruned[v];
      canvas.circle(p, std::max(canvas.length(scene.radius), 2 * kDot), " stroke-width=\"0.5\"");
      canvas.line(p, scene.centroids[c], stroke(kMark));
    }
    canvas.circle(scene.centroids[c], kDot, filled(kMark));
  }
}

/// Triangles in the colours of their faces; edges that could not be filled in the second colour.
void filled(const Scene& scene, Canvas& canvas) {
  const std::vector<Scene::Polygon>& polygons = scene.solid_faces;
  const std::vector<std::vector<TriangleD>> fillings = scene.fillings();
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    const std::string ink = colour(f);
    canvas.open_group(fmt::format(" fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.3\"", ink));
    for (const TriangleD& t : fillings[f]) {
      canvas.paths({{{t.begin(), t.end()}}}, {});
    }
    canvas.close_group();
  }
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    canvas.paths(polygons[f], fillings[f].empty() ? stroke(kMark) : std::string());
  }
}

void polylines(std::span<const Bridged> faces, Canvas& canvas) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    canvas.paths(faces[f].polylines, fmt::format(" fill=\"{}\" fill-opacity=\"0.3\"", colour(f)));
  }
  for (const Bridged& face : faces) {
    for (const auto& [p, q] : face.bridges) {
      canvas.line(p, q, stroke(kMark) + " stroke-width=\"2\"");
    }
  }
}

/// Chosen faces filled, their boundary as chain in the second colour, all faces numbered.
void boundary(const Scene& scene, std::span<const std::size_t> chosen, Canvas& canvas) {
  const std::vector<Scene::Polygon>& polygons = scene.solid_faces;
  for (const std::size_t f : chosen) {
    canvas.paths(polygons[f], fmt::format(" fill=\"{}\" stroke=\"none\"", kDepthColours[1]));
  }
  edges(scene, scene.edges, canvas);
  for (const auto& [p, q] : scene.boundary(chosen)) {
    canvas.line(p, q, stroke(kMark) + " stroke-width=\"3\"");
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

/// The chosen faces; all of them where none is chosen.
std::vector<std::size_t> chosen_faces(const LarPicture& options, std::size_t count) {
  for (const std::size_t f : options.faces) {
    if (f < count) continue;
    throw Error(ErrorCode::BadInput,
                "no such face; they are numbered from 0 to the last of " + std::to_string(count),
                {}, std::to_string(f));
  }
  if (!options.faces.empty()) return options.faces;
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void draw(const Scene& scene, const LarPicture& options, Canvas& canvas) {
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
      return filled(scene, canvas);
    case LarShow::Polylines:
      return polylines(scene.bridged(), canvas);
    case LarShow::Boundary:
      return boundary(scene, chosen_faces(options, scene.solid_faces.size()), canvas);
  }
}

}  // namespace

std::string picture(const Scene& scene, const LarPicture& options) {
  check(options);
  Canvas canvas(box_of(scene), options.y_up);
  draw(scene, options, canvas);
  return canvas.svg();
}

}  // namespace plumbline::svg
