// The findings as a layer of points for geographic information systems: RFC 7946.

#include <optional>
#include <vector>

#include "output/json/writer.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

/// Null where there is no text.
auto text(std::string words) {
  return words.empty() ? std::nullopt : std::optional(std::move(words));
}

std::string sources_text(const SegmentSet& input, const Finding& finding) {
  std::string words;
  for (const SourceId source : sources_of(input, finding.segments)) {
    words += (words.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  }
  return words;
}

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
                member("sources", text(sources_text(input, f))));
}

auto geometry(const Finding& f) {
  return given(f.kind != CellKind::Complex, [&f] {
    return object(member("type", "Point"), member("coordinates", nearest(f.where)));
  });
}

/// The member `crs` of GeoJSON before RFC 7946, which readers still follow.
auto named(const std::string& crs) {
  return object(member("type", "name"), member("properties", object(member("name", crs))));
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
  const auto feature = [&](std::size_t i) {
    const Cause cause = i < check.causes.size() ? check.causes[i] : Cause{};
    return object(
        member("type", "Feature"), member("id", i + 1), member("geometry", geometry(findings[i])),
        member("properties", properties(check.input, findings[i], cause, i + 1, group_of[i])));
  };
  return document(
      object(member("type", "FeatureCollection"),
             when(!check.input.crs.empty(), [&] { return member("crs", named(check.input.crs)); }),
             member("features", list(findings.size(), feature))));
}

}  // namespace plumbline
