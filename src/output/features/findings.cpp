// Findings of a check, and defects of a diagnosis with the openings behind them, as layers of
// points.

#include <algorithm>
#include <optional>

#include "output/features/points.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

using namespace features;

template <class T>
FeatureValue given(const std::optional<T>& value) {
  if (!value) return {};
  if constexpr (std::is_same_v<T, double>) return *value;
  return number(static_cast<std::size_t>(*value));
}

Feature feature_of(const SegmentSet& input, const Finding& f, const Cause& cause,
                   std::size_t finding, std::optional<std::size_t> group) {
  const bool has_place = f.kind != CellKind::Complex;
  std::vector<FeatureValue> values{number(finding),
                                   given(group),
                                   text(to_text(f.kind)),
                                   text(to_text(f.disagreement)),
                                   text(f.invariant ? to_text(*f.invariant) : ""),
                                   text(cause.stage),
                                   text(cause.rule),
                                   text(f.message),
                                   text(cause.advice),
                                   given(f.distance),
                                   text(has_place ? exact_text(f.where.x) : ""),
                                   text(has_place ? exact_text(f.where.y) : ""),
                                   sources_text(input, f.segments)};
  if (!has_place) return {{}, std::move(values)};
  return point_at(f.where, std::move(values), to_text(f.disagreement));
}

}  // namespace

FeatureLayer finding_layer(const Check& check) {
  FeatureLayer layer{"findings",
                     FeatureGeometry::Point,
                     {"number", "group", "kind", "disagreement", "invariant", "stage", "rule",
                      "message", "advice", "distance", "exact_x", "exact_y", "sources"},
                     {},
                     true};
  const std::vector<Finding>& findings = check.comparison.findings;
  std::vector<std::optional<std::size_t>> group_of(findings.size());
  for (std::size_t g = 0; g < check.groups.size(); ++g) {
    for (const std::size_t f : check.groups[g].findings) group_of[f - 1] = g + 1;
  }
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Cause cause = i < check.causes.size() ? check.causes[i] : Cause{};
    layer.features.push_back(feature_of(check.input, findings[i], cause, i + 1, group_of[i]));
  }
  return layer;
}

FeatureLayer defect_layer(const Diagnosis& diagnosis, const SegmentSet& input) {
  FeatureLayer layer{"defects",
                     FeatureGeometry::Point,
                     {"number", "rank", "kind", "message", "size", "open_area", "tolerance",
                      "exact_x", "exact_y", "sources"},
                     {},
                     true};
  const std::vector<std::size_t> order = by_effect(diagnosis);
  std::vector<std::size_t> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = i + 1;
  for (std::size_t i = 0; i < diagnosis.defects.size(); ++i) {
    const Defect& d = diagnosis.defects[i];
    layer.features.push_back(
        point_at(d.where,
                 {number(i + 1), number(ranks[i]), text(to_text(d.kind)), text(d.message), d.size,
                  given(d.open_area), given(d.proposed_tolerance), text(exact_text(d.where.x)),
                  text(exact_text(d.where.y)), sources_text(input, d.segments)},
                 to_text(d.kind)));
  }
  for (const Opening& o : diagnosis.openings) {  // which have no rank: they are no defects
    layer.features.push_back(point_at(o.where,
                                      {number(layer.features.size() + 1),
                                       {},
                                       text("opening"),
                                       text("a way through, as wide as a door"),
                                       o.width,
                                       {},
                                       {},
                                       text(exact_text(o.where.x)),
                                       text(exact_text(o.where.y)),
                                       sources_text(input, o.segments)},
                                      "opening"));
  }
  return layer;
}

}  // namespace plumbline
