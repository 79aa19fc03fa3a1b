// Cells of a complex with what is known of them.

#include "plumbline/features.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "features/parts.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

PointD place(const ExactComplex& complex, VertexId v) { return complex.vertices.nearest(v); }

using features::number;

std::string sources_text(const SegmentSet& input, std::span<const SegmentId> segments) {
  std::string text;
  std::unordered_set<std::size_t> seen;
  for (const SegmentId s : segments) {
    if (s >= input.segment_source.size()) continue;
    const SourceId source = input.segment_source[s];
    if (!seen.insert(source).second) continue;
    text += (text.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  }
  return text;
}

std::string list_of(const std::vector<Neighbour>& neighbours) {
  std::string text;
  for (const Neighbour& next : neighbours) {
    if (next.face == kUnbounded) continue;
    text += fmt::format("{}{}", text.empty() ? "" : " ", static_cast<std::size_t>(next.face));
  }
  return text;
}

}  // namespace

FeatureLayer face_layer(const ExactComplex& complex, const SegmentSet& input,
                        const Rounding& rounding) {
  FeatureLayer layer{
      "faces",
      FeatureGeometry::Polygon,
      {"face", "area", "area_exact", "perimeter", "depth", "parent", "neighbours", "sources"},
      {}};
  const ExactComplex& rounded = rounding.complex;
  const bool is_same = rounding.has_same_incidences();
  const std::vector<Rational> areas = face_areas(is_same ? complex : rounded);
  const std::vector<double> lengths = perimeters(rounded);
  const auto next = neighbours(rounded);
  const auto sources = face_sources(rounded);
  for (const FacePolygon& polygon : polygons(rounded)) {
    const FaceId f = polygon.face;
    Feature feature;
    feature.parts = features::parts(rounded, polygon);
    const Rational& area = areas.at(is_same ? rounding.face_origin.at(f) : f);
    feature.values = {number(f),        nearest_double(area),           exact_text(area),
                      lengths[f],       number(rounded.face_depth[f]),  number(rounded.parent(f)),
                      list_of(next[f]), sources_text(input, sources[f])};
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

FeatureLayer edge_layer(const SegmentSet& input, const Rounding& rounding) {
  const ExactComplex& rounded = rounding.complex;
  FeatureLayer layer{
      "edges", FeatureGeometry::Line, {"edge", "tail", "head", "left", "right", "sources"}, {}};
  layer.features.reserve(rounded.edge_count());
  for (std::size_t e = 0; e < rounded.edge_count(); ++e) {
    const auto [tail, head] = rounded.edges[e];
    Feature feature;
    feature.parts = {{place(rounded, tail), place(rounded, head)}};
    feature.values = {number(e),
                      number(tail),
                      number(head),
                      number(rounded.halfedge_face[halfedge(EdgeId(e), false)]),
                      number(rounded.halfedge_face[halfedge(EdgeId(e), true)]),
                      sources_text(input, rounded.edge_sources[e])};
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

FeatureLayer vertex_layer(const Rounding& rounding) {
  const ExactComplex& rounded = rounding.complex;
  FeatureLayer layer{"vertices", FeatureGeometry::Point, {"vertex", "degree"}, {}};
  std::vector<std::size_t> degree(rounded.vertices.size());
  for (const Edge& edge : rounded.edges) {
    ++degree[edge.tail];
    ++degree[edge.head];
  }
  layer.features.reserve(degree.size());
  for (std::size_t v = 0; v < degree.size(); ++v) {
    layer.features.push_back({{{place(rounded, VertexId(v))}}, {number(v), number(degree[v])}});
  }
  return layer;
}

std::string note_of(const Rounding& rounding) {
  if (rounding.method == RoundingMethod::SnapRounded) {
    return "snap rounded: a valid complex, proven, whose vertices moved and in part merged";
  }
  return (rounding.method == RoundingMethod::NearestDoubles ? "nearest doubles"
                                                            : "nearest points of a grid") +
         std::string(", the same incidences as the exact complex, proven");
}

}  // namespace plumbline
