// Features as DXF R2000: lines joined to polylines, polygons as a closed polyline for each ring,
// points, and names of polygons as texts.

#include <algorithm>

#include "output/features/chains.hpp"
#include "output/features/dxf_frame.hpp"
#include "output/features/label_place.hpp"
#include "output/features/numbering.hpp"
#include "plumbline/features.hpp"
#include "plumbline/output.hpp"
#include "structure/colour_index.hpp"
#include "structure/dxf_units.hpp"

namespace plumbline {
namespace features {
namespace {

class DxfFile {
 public:
  explicit DxfFile(const Features& features) : features_(features) {
    for (const Layer& layer : features.drawing_layers) used(layer.name, colour_number(layer.rgb));
    constexpr std::size_t kBytes = 160;  // of a line, about
    std::size_t count = 0;
    for (const FeatureLayer& layer : features.layers) count += layer.features.size();
    out_.reserve(kBytes * count);
    for (const FeatureLayer& layer : features.layers) {
      for (const Feature& feature : layer.features) {
        for (const auto& part : feature.parts) extend(part);
      }
    }
  }

  std::string text() && {
    for (const FeatureLayer& layer : features_.layers) {
      switch (layer.geometry) {
        case FeatureGeometry::Point:
          points(layer);
          break;
        case FeatureGeometry::Line:
          lines(layer);
          break;
        case FeatureGeometry::Polygon:
          polygons(layer);
          names(layer);
          break;
      }
    }
    frame_.comment = features_.note;
    frame_.unit = features_.unit ? code_of_unit(features_.unit->metres) : 0;
    return dxf_file(frame_, std::move(out_));
  }

 private:
  void extend(const std::vector<PointD>& points) {
    for (const PointD& p : points) {
      if (is_empty_) frame_.least = frame_.greatest = p;
      is_empty_ = false;
      frame_.least = {std::min(frame_.least.x, p.x), std::min(frame_.least.y, p.y)};
      frame_.greatest = {std::max(frame_.greatest.x, p.x), std::max(frame_.greatest.y, p.y)};
    }
  }

  const std::string& layer_of(const FeatureLayer& layer, const Feature& feature) {
    const std::string& name = feature.layer.empty() ? layer.name : feature.layer;
    if (last_legal_ == nullptr || last_name_ != name) {
      last_name_ = name;
      last_legal_ = &used(name);
    }
    return *last_legal_;
  }

  /// The layer's legal name; a row of the table at its first use.
  const std::string& used(const std::string& name, std::int64_t colour = kWhiteOrBlack) {
    const std::string& legal = names_.legal(name);
    if (listed_.insert(legal).second) frame_.layers.push_back({legal, colour});
    return legal;
  }

  void begin(const char* type, const std::string& layer, const char* subclass) {
    out_.text(0, type);
    out_.handle();
    out_.text(330, kModelSpace);
    out_.text(100, "AcDbEntity");
    out_.text(8, layer);
    out_.text(100, subclass);
  }

  void line(const std::string& layer, const PointD& a, const PointD& b) {
    begin("LINE", layer, "AcDbLine");
    out_.point(10, a);
    out_.point(11, b);
  }

  template <class Places>
  void polyline(const std::string& layer, const Places& places, std::size_t count, bool is_closed) {
    begin("LWPOLYLINE", layer, "AcDbPolyline");
    out_.integer(90, static_cast<std::int64_t>(count));
    out_.integer(70, is_closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) out_.flat_point(10, places(i));
  }

  void points(const FeatureLayer& layer) {
    for (const Feature& feature : layer.features) {
      if (feature.parts.empty()) continue;
      begin("POINT", layer_of(layer, feature), "AcDbPoint");
      out_.point(10, feature.parts[0][0]);
    }
  }

  void lines(const FeatureLayer& layer) {
    Numbering<PointD> points;
    Numbering<std::string> kinds;
    std::vector<ChainEdge> edges;
    for (const Feature& feature : layer.features) {
      const std::uint32_t kind = kinds.number(layer_of(layer, feature));
      const std::vector<PointD>& part = feature.parts[0];
      for (std::size_t i = 0; i + 1 < part.size(); ++i) {
        const ChainEdge edge{points.number(part[i]), points.number(part[i + 1]), kind};
        if (edge.a != edge.b) edges.push_back(edge);
      }
    }
    const Chains joined = chains(edges, std::vector<bool>(points.things().size()));
    std::vector<std::uint32_t> kind_of(joined.points.size());
    for (std::size_t e = 0; e < edges.size(); ++e) kind_of[joined.chain_of[e]] = edges[e].kind;
    for (std::size_t c = 0; c < joined.points.size(); ++c) {
      const auto chain = joined.points[c];
      const auto place = [&](std::size_t i) { return points.things()[chain[i]]; };
      const std::string& name = kinds.things()[kind_of[c]];
      if (chain.size() == 2) {
        line(name, place(0), place(1));
      } else {
        const bool is_closed = chain.front() == chain.back();
        polyline(name, place, chain.size() - (is_closed ? 1 : 0), is_closed);
      }
    }
  }

  void polygons(const FeatureLayer& layer) {
    for (const Feature& feature : layer.features) {
      const std::string& name = layer_of(layer, feature);
      for (const auto& ring : feature.parts) {
        polyline(
            name, [&ring](std::size_t i) { return ring[i]; }, ring.size(), true);
      }
    }
  }

  /// Of a layer with a column "name", each as a text within the polygon.
  void names(const FeatureLayer& layer) {
    const auto column = std::ranges::find(layer.columns, "name");
    if (column == layer.columns.end()) return;
    const auto at = static_cast<std::size_t>(column - layer.columns.begin());
    const double largest =
        std::max(frame_.greatest.x - frame_.least.x, frame_.greatest.y - frame_.least.y) / 50;
    for (const Feature& feature : layer.features) {
      const auto* name = std::get_if<std::string>(&feature.values[at]);
      if (name == nullptr || name->empty()) continue;
      const LabelPlace place = label_place(feature.parts);
      constexpr double kWidth = 1.25;  // of a letter with its share of the margin, in heights
      const double fitting = place.width / (kWidth * static_cast<double>(name->size()));
      begin("TEXT", used(layer.name + " names"), "AcDbText");
      out_.point(10, place.middle);
      out_.real(40, std::min({largest, fitting, place.height / 2}));
      out_.text(1, dxf_text(*name));
      out_.integer(72, 1);  // centred
      out_.point(11, place.middle);
      out_.text(100, "AcDbText");
      out_.integer(73, 2);  // half of it above
    }
  }

  const Features& features_;
  DxfFrame frame_;
  Groups out_;
  LayerNames names_;
  std::set<std::string> listed_;
  std::string last_name_;  ///< of a layer, and what is legal for it
  const std::string* last_legal_ = nullptr;
  bool is_empty_ = true;
};

}  // namespace
}  // namespace features

std::string to_dxf(const Features& features) { return features::DxfFile(features).text(); }

}  // namespace plumbline
