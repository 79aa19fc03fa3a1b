// Cells of a complex with what is known of them.

#include "plumbline/features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "features/parts.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

PointD place(const ExactComplex& complex, VertexId v) { return complex.vertices.nearest(v); }

using features::number;

template <class... Value>
void add(std::vector<FeatureValue>& values, Value&&... value) {
  values.reserve(sizeof...(value));
  (values.emplace_back(std::forward<Value>(value)), ...);
}

/// The elements and layers that segments come from, each source made a text once.
class Origins {
 public:
  explicit Origins(const SegmentSet& input)
      : input_(input), elements_(input.sources.size()), seen_(input.sources.size()) {}

  struct Texts {
    std::string first_layer, layers, sources;
  };
  Texts of(std::span<const SegmentId> segments) {
    Texts texts;
    layers_.clear();
    ++round_;
    for (const SegmentId s : segments) {
      if (s >= input_.segment_source.size()) continue;
      const SourceId source = input_.segment_source[s];
      if (std::exchange(seen_[source], round_) == round_) continue;
      const Element& element = element_of(source);
      (texts.sources += texts.sources.empty() ? "" : "; ") += element.text;
      if (texts.first_layer.empty()) texts.first_layer = element.layer;
      if (element.layer.empty() || std::ranges::find(layers_, element.layer) != layers_.end()) {
        continue;
      }
      layers_.push_back(element.layer);
      (texts.layers += texts.layers.empty() ? "" : "; ") += element.layer;
    }
    return texts;
  }

 private:
  struct Element {
    std::string text, layer;
  };
  const Element& element_of(SourceId source) {
    Element& element = elements_[source];
    if (element.text.empty()) {
      const Source known = input_.sources[source];
      element = {to_text(known, input_.files), known.layer};
    }
    return element;
  }

  const SegmentSet& input_;
  std::vector<Element> elements_;    ///< per source
  std::vector<std::uint32_t> seen_;  ///< per source in which round
  std::uint32_t round_ = 0;
  std::vector<std::string_view> layers_;  ///< of this round
};

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
  FeatureLayer layer{"faces",
                     FeatureGeometry::Polygon,
                     {"face", "area", "area_exact", "perimeter", "depth", "parent", "neighbours",
                      "layers", "sources"},
                     {}};
  const ExactComplex& rounded = rounding.complex;
  const bool is_same = rounding.has_same_incidences();
  const std::vector<Rational> areas = face_areas(is_same ? complex : rounded);
  const std::vector<double> lengths = perimeters(rounded);
  const auto next = neighbours(rounded);
  const auto sources = face_sources(rounded);
  Origins origins(input);
  for (const FacePolygon& polygon : polygons(rounded)) {
    const FaceId f = polygon.face;
    Feature feature;
    feature.parts = features::parts(rounded, polygon);
    const Rational& area = areas.at(is_same ? rounding.face_origin.at(f) : f);
    Origins::Texts of = origins.of(sources[f]);
    add(feature.values, number(f), nearest_double(area), exact_text(area), lengths[f],
        number(rounded.face_depth[f]), number(rounded.parent(f)), list_of(next[f]),
        std::move(of.layers), std::move(of.sources));
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

FeatureLayer edge_layer(const SegmentSet& input, const Rounding& rounding) {
  const ExactComplex& rounded = rounding.complex;
  FeatureLayer layer{"edges",
                     FeatureGeometry::Line,
                     {"edge", "tail", "head", "left", "right", "layers", "sources"},
                     {}};
  layer.features.reserve(rounded.edge_count());
  Origins origins(input);
  for (std::size_t e = 0; e < rounded.edge_count(); ++e) {
    const auto [tail, head] = rounded.edges[e];
    Origins::Texts of = origins.of(rounded.edge_sources[e]);
    Feature& feature = layer.features.emplace_back();
    feature.parts.push_back({place(rounded, tail), place(rounded, head)});
    feature.layer = std::move(of.first_layer);
    add(feature.values, number(e), number(tail), number(head),
        number(rounded.halfedge_face[halfedge(EdgeId(e), false)]),
        number(rounded.halfedge_face[halfedge(EdgeId(e), true)]), std::move(of.layers),
        std::move(of.sources));
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
