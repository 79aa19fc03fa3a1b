// The defects, and the openings behind them, as a layer of points.

#include <algorithm>

#include "output/geojson/layer.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

/// What is known of a feature. An opening has no rank: it is no defect.
struct Row {
  std::string kind, message;
  const Point& where;
  double size;
  std::optional<std::size_t> rank;
  std::optional<double> open_area, tolerance;
  const std::vector<SegmentId>& segments;
};

auto properties(const SegmentSet& input, const Row& row, std::size_t number) {
  return object(member("number", number), member("rank", row.rank), member("kind", row.kind),
                member("message", row.message), member("size", row.size),
                member("open_area", row.open_area), member("tolerance", row.tolerance),
                member("exact_x", exact_text(row.where.x)),
                member("exact_y", exact_text(row.where.y)),
                member("sources", text(sources_text(input, row.segments))));
}

}  // namespace
}  // namespace json

std::string to_geojson(const Diagnosis& diagnosis, const SegmentSet& input) {
  using namespace json;
  const std::vector<Defect>& defects = diagnosis.defects;
  std::vector<std::size_t> ranks(defects.size());
  const std::vector<std::size_t> order = by_effect(diagnosis);
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = i + 1;
  const auto row = [&](std::size_t i) {
    if (i < defects.size()) {
      const Defect& d = defects[i];
      return Row{to_text(d.kind),      d.message, d.where, d.size, ranks[i], d.open_area,
                 d.proposed_tolerance, d.segments};
    }
    const Opening& o = diagnosis.openings[i - defects.size()];
    return Row{"opening", "a way through, as wide as a door", o.where, o.width, {}, {}, {},
               o.segments};
  };
  return layer(input, defects.size() + diagnosis.openings.size(), [&](std::size_t i) {
    const Row known = row(i);
    return object(member("type", "Feature"), member("id", i + 1),
                  member("geometry", point(known.where)),
                  member("properties", properties(input, known, i + 1)));
  });
}

}  // namespace plumbline
