// Pieces of overlays as polygons with what they lie in.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "features/parts.hpp"
#include "plumbline/features.hpp"

namespace plumbline {
namespace {

using features::number;

/// The elements that regions were read from, each made a text once.
class Elements {
 public:
  explicit Elements(const Overlay& overlay) : overlay_(overlay), texts_(overlay.regions.size()) {}

  std::string of(std::span<const RegionId> regions) {
    std::string text;
    for (const RegionId r : regions) {
      if (texts_[r].empty()) texts_[r] = source_text(overlay_.regions[r], overlay_.input);
      (text += text.empty() ? "" : "; ") += texts_[r];
    }
    return text;
  }

 private:
  const Overlay& overlay_;
  std::vector<std::string> texts_;
};

}  // namespace

FeatureLayer piece_layer(const Overlay& overlay, const Rounding& rounding) {
  FeatureLayer layer{
      "pieces", FeatureGeometry::Polygon, {"piece", "first", "second", "area", "area_exact"}, {}};
  std::vector<std::size_t> piece_of(overlay.complex.face_count());  // from 1
  for (std::size_t p = 0; p < overlay.pieces.size(); ++p) {
    for (const FaceId f : overlay.pieces[p].faces) piece_of[f] = p + 1;
  }
  // Of a face that rounding parted each part has an area of its own.
  const bool is_same = rounding.has_same_incidences();
  const std::vector<Rational> areas = face_areas(is_same ? overlay.complex : rounding.complex);
  std::vector<std::vector<Feature>> of_pieces(overlay.pieces.size());
  Elements elements(overlay);
  for (const FacePolygon& polygon : polygons(rounding.complex)) {
    const FaceId origin = rounding.face_origin.at(polygon.face);
    if (piece_of[origin] == 0) continue;
    const std::size_t p = piece_of[origin] - 1;
    const Rational& area = areas.at(is_same ? origin : polygon.face);
    const Piece& piece = overlay.pieces[p];
    of_pieces[p].push_back({features::parts(rounding.complex, polygon),
                            {number(p + 1), elements.of(piece.first), elements.of(piece.second),
                             nearest_double(area), exact_text(area)}});
  }
  for (auto& features : of_pieces) {
    for (Feature& feature : features) layer.features.push_back(std::move(feature));
  }
  return layer;
}

}  // namespace plumbline
