// The findings as a layer of points for geographic information systems: RFC 7946.

#include "output/json/writer.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

void write_text(JsonWriter& json, const char* key, const std::string& value) {
  json.Key(key);
  if (value.empty())
    json.Null();
  else
    json.text(value);
}

void write_geometry(JsonWriter& json, const Finding& finding) {
  json.Key("geometry");
  const PointD place = nearest(finding.where);
  if (finding.kind == CellKind::Complex) {
    json.Null();
    return;
  }
  json.StartObject();
  json.Key("type");
  json.text("Point");
  json.Key("coordinates");
  json.StartArray();
  json.number(place.x);
  json.number(place.y);
  json.EndArray();
  json.EndObject();
}

std::string sources_text(const SegmentSet& input, const Finding& finding) {
  std::string text;
  for (const SourceId source : sources_of(input, finding.segments))
    text += (text.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  return text;
}

void write_properties(JsonWriter& json, const SegmentSet& input, const Finding& finding,
                      const Cause& cause, std::size_t number) {
  const bool has_place = finding.kind != CellKind::Complex;
  json.Key("properties");
  json.StartObject();
  json.Key("number");
  json.count(number);
  write_text(json, "kind", to_text(finding.kind));
  write_text(json, "disagreement", to_text(finding.disagreement));
  write_text(json, "invariant", finding.invariant ? to_text(*finding.invariant) : "");
  write_text(json, "stage", cause.stage);
  write_text(json, "rule", cause.rule);
  write_text(json, "message", finding.message);
  write_text(json, "advice", cause.advice);
  json.Key("distance");
  if (finding.distance)
    json.number(*finding.distance);
  else
    json.Null();
  write_text(json, "exact_x", has_place ? exact_text(finding.where.x) : "");
  write_text(json, "exact_y", has_place ? exact_text(finding.where.y) : "");
  write_text(json, "sources", sources_text(input, finding));
  json.EndObject();
}

}  // namespace

std::string to_geojson(const Check& check) {
  JsonWriter json;
  json.StartObject();
  json.Key("type");
  json.text("FeatureCollection");
  json.Key("features");
  json.StartArray();
  const std::vector<Finding>& findings = check.comparison.findings;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    json.StartObject();
    json.Key("type");
    json.text("Feature");
    json.Key("id");
    json.count(i + 1);
    write_geometry(json, findings[i]);
    write_properties(json, check.input, findings[i],
                     i < check.causes.size() ? check.causes[i] : Cause{}, i + 1);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
