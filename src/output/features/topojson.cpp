// Features as TopoJSON: what polygons and lines have in common is an arc, which is there once.

#include <algorithm>

#include "output/features/chains.hpp"
#include "output/features/numbering.hpp"
#include "output/features/properties.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace features {
namespace {

class Arcs {
 public:
  explicit Arcs(const Features& features) {
    for (const FeatureLayer& layer : features.layers) {
      if (layer.geometry == FeatureGeometry::Point) continue;
      for (const Feature& feature : layer.features) {
        for (const auto& part : feature.parts) add(part, layer.geometry);
      }
    }
    is_node_.resize(points_.things().size());
    chains_ = chains(edges_, is_node_);
    is_end_ = is_node_;
    for (std::size_t c = 0; c < chains_.points.size(); ++c) {
      is_end_[chains_.points[c].front()] = is_end_[chains_.points[c].back()] = true;
    }
  }

  std::size_t size() const { return chains_.points.size(); }
  auto arc(std::size_t c) const {
    const auto chain = chains_.points[c];
    return json::list(chain.size(), [this, chain](std::size_t i) -> const PointD& {
      return points_.things()[chain[i]];
    });
  }

  /// The arcs along the next part, in their order, as TopoJSON numbers them: ~i for i backwards.
  /// A ring begins where an arc does.
  std::vector<std::int32_t> along_next() {
    const auto edges = part_edges_[next_part_];
    const auto starts = part_starts_[next_part_++];
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(starts, [this](std::uint32_t p) { return is_end_[p]; }) -
        starts.begin());
    std::vector<std::int32_t> result;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::size_t i = (first + k) % edges.size();
      if (!is_end_[starts[i]]) continue;
      const std::uint32_t edge = edges[i];
      const auto chain = static_cast<std::int32_t>(chains_.chain_of[edge]);
      const bool is_against = (edges_[edge].a != starts[i]) != chains_.runs_against[edge];
      result.push_back(is_against ? ~chain : chain);
    }
    return result;
  }

 private:
  void add(const std::vector<PointD>& part, FeatureGeometry geometry) {
    const bool is_ring = geometry == FeatureGeometry::Polygon;
    std::vector<std::uint32_t> points;
    for (const PointD& p : part) points.push_back(points_.number(p));
    if (is_ring) points.push_back(points.front());
    std::vector<std::uint32_t> starts, along;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i] == points[i + 1]) continue;
      const std::uint32_t edge = pairs_.number(std::minmax(points[i], points[i + 1]));
      if (edge == edges_.size()) edges_.push_back({points[i], points[i + 1]});
      starts.push_back(points[i]);
      along.push_back(edge);
    }
    part_starts_.push_back(starts);
    part_edges_.push_back(along);
    if (is_ring) return;
    is_node_.resize(points_.things().size());
    is_node_[points.front()] = is_node_[points.back()] = true;
  }

  Numbering<PointD> points_;
  Numbering<std::pair<std::uint32_t, std::uint32_t>> pairs_;  ///< of points, per edge
  std::vector<ChainEdge> edges_;
  Lists<std::uint32_t> part_starts_, part_edges_;  ///< per part its edges, and where each starts
  std::size_t next_part_ = 0;
  std::vector<bool> is_node_, is_end_;
  Chains chains_;
};

}  // namespace
}  // namespace features

namespace json {
namespace {

auto geometry(const FeatureLayer& layer, const Feature& feature, features::Arcs& arcs) {
  const FeatureGeometry type = layer.geometry;
  const auto along = [&arcs](const auto&) { return arcs.along_next(); };
  return object(member("type", given(!feature.parts.empty(), [type] { return type_name(type); })),
                when(type == FeatureGeometry::Point && !feature.parts.empty(),
                     [&feature] { return member("coordinates", feature.parts[0][0]); }),
                when(type == FeatureGeometry::Line,
                     [&feature, along] { return member("arcs", along(feature.parts[0])); }),
                when(type == FeatureGeometry::Polygon,
                     [&feature, along] { return member("arcs", list(feature.parts, along)); }),
                member("properties", object(columns_of(layer, feature))));
}

}  // namespace
}  // namespace json

std::string to_topojson(const Features& features) {
  using namespace json;
  features::Arcs arcs(features);
  const auto object_of = [&arcs](const FeatureLayer& layer) {
    const auto row = [&](const Feature& feature) { return geometry(layer, feature, arcs); };
    return member(layer.name, object(member("type", "GeometryCollection"),
                                     member("geometries", rows(layer.features, row))));
  };
  return document(object(member("type", "Topology"), head_of(features),
                         member("arcs", rows(Numbers(0, arcs.size()),
                                             [&](std::size_t c) { return arcs.arc(c); })),
                         member("objects", object(each(features.layers, object_of)))),
                  Layout::Dense, bytes_of(features));
}

}  // namespace plumbline
