// The findings as a layer of points for geographic information systems: RFC 7946.

#include <optional>
#include <vector>

#include "output/geojson/layer.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto properties(const SegmentSet& input, const Finding& f, const Cause& cause, std::size_t number,
                std::optional<std::size_t> group) {
  const bool has_place = f.kind != CellKind::Complex;
  return object(member("number", number), member("group", group),
                member("kind", text(to_text(f.kind))),
                member("disagreement", text(to_text(f.disagreement))),
                member("invariant", text(f.invariant ? to_text(*f.invariant) : "")),
                member("stage", text(cause.stage)), member("rule", text(cause.rule)),
                member("message", text(f.message)), member("advice", text(cause.advice)),
                member("distance", f.distance),
                member("exact_x", text(has_place ? exact_text(f.where.x) : "")),
                member("exact_y", text(has_place ? exact_text(f.where.y) : "")),
                member("sources", text(sources_text(input, f.segments))));
}

auto geometry(const Finding& f) {
  return given(f.kind != CellKind::Complex, [&f] { return point(f.where); });
}

}  // namespace
}  // namespace json

std::string to_geojson(const Check& check) {
  using namespace json;
  const std::vector<Finding>& findings = check.comparison.findings;
  std::vector<std::optional<std::size_t>> group_of(findings.size());
  for (std::size_t g = 0; g < check.groups.size(); ++g) {
    for (const std::size_t number : check.groups[g].findings) group_of[number - 1] = g + 1;
  }
  return layer(check.input, findings.size(), [&](std::size_t i) {
    const Cause cause = i < check.causes.size() ? check.causes[i] : Cause{};
    return object(
        member("type", "Feature"), member("id", i + 1), member("geometry", geometry(findings[i])),
        member("properties", properties(check.input, findings[i], cause, i + 1, group_of[i])));
  });
}

}  // namespace plumbline
