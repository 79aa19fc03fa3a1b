// The comparison as members of a JSON object; documented in docs/json.md.

#include "output/json/check.hpp"

#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

void write_optional(JsonWriter& json, const char* key, const std::optional<double>& value) {
  json.Key(key);
  if (value)
    json.number(*value);
  else
    json.Null();
}

/// An exact number as text, with the nearest double; or null.
void write_exact(JsonWriter& json, const char* key, const std::optional<Rational>& value) {
  json.Key(key);
  if (!value) {
    json.Null();
    return;
  }
  json.StartObject();
  json.Key("exact");
  json.exact(*value);
  json.Key("nearest");
  json.number(nearest_double(*value));
  json.EndObject();
}

void write_counts(JsonWriter& json, const char* key, const Counts& counts) {
  json.Key(key);
  json.StartObject();
  for (const CountRow& row : count_rows()) {
    json.Key(row.name);
    json.count(counts.*row.member);
  }
  json.EndObject();
}

void write_engine(JsonWriter& json, const Answer& answer) {
  json.Key("engine");
  json.StartObject();
  json.Key("name");
  json.text(answer.engine);
  json.Key("version");
  json.text(answer.version);
  json.Key("title");
  json.text(answer.title);
  json.Key("parameters");
  json.StartObject();
  for (const auto& [name, value] : answer.parameters) {
    json.Key(name.c_str());
    if (const auto* number = std::get_if<double>(&value)) {
      json.number(*number);
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      json.Int64(*integer);
    } else {
      json.text(std::get<std::string>(value));
    }
  }
  json.EndObject();
  json.EndObject();
}

void write_summary(JsonWriter& json, const Check& check) {
  const Comparison& c = check.comparison;
  json.Key("verdict");
  json.text(c.agree() ? "agree" : "disagree");
  write_engine(json, check.answer);
  json.Key("float_valid");
  json.Bool(c.float_valid);
  json.Key("exact");
  json.Bool(check.input.ledger.empty());
  write_optional(json, "radius", check.answer.radius);
  json.Key("tolerance");
  json.number(c.tolerance);
  json.Key("largest_displacement");
  json.number(c.largest_displacement);
  json.Key("counts");
  json.StartObject();
  write_counts(json, "exact", c.exact_counts);
  write_counts(json, "doubles", check.conversion.float_counts);
  write_counts(json, "float", c.float_counts);
  json.EndObject();
  json.Key("compared");
  json.text(c.compared == Compared::All ? "all" : "graph");
  json.Key("matched");
  json.StartObject();
  json.Key("vertices");
  json.count(c.matched_vertices);
  json.Key("edges");
  json.count(c.matched_edges);
  json.Key("faces");
  json.count(c.matched_faces);
  json.EndObject();
}

void write_cause(JsonWriter& json, const Cause* known) {
  json.Key("cause");
  if (known == nullptr) {
    json.Null();
    return;
  }
  const Cause& cause = *known;
  json.StartObject();
  json.Key("stage");
  json.text(cause.stage);
  json.Key("round");
  json.count(cause.round);
  json.Key("rule");
  json.text(cause.rule);
  json.Key("explanation");
  json.text(cause.explanation);
  json.Key("advice");
  json.text(cause.advice);
  json.Key("confirmed");
  json.Bool(cause.confirmed);
  json.Key("remade");
  if (cause.remade)
    json.Bool(*cause.remade);
  else
    json.Null();
  json.EndObject();
}

void write_finding(JsonWriter& json, const SegmentSet& input, const Finding& finding,
                   const Cause* cause, std::size_t number) {
  json.StartObject();
  json.Key("number");
  json.count(number);
  json.Key("kind");
  json.text(to_text(finding.kind));
  json.Key("disagreement");
  json.text(to_text(finding.disagreement));
  json.Key("invariant");
  if (finding.invariant)
    json.text(to_text(*finding.invariant));
  else
    json.Null();
  json.Key("message");
  json.text(finding.message);
  json.Key("where");
  if (finding.kind == CellKind::Complex) {
    json.Null();
  } else {
    json.place(finding.where);
  }
  json.Key("because");
  json.counts(finding.because);
  json.Key("exact_cells");
  json.counts(finding.exact_cells);
  json.Key("float_cells");
  json.counts(finding.float_cells);
  write_optional(json, "distance", finding.distance);
  write_exact(json, "squared_distance", finding.squared_distance);
  write_exact(json, "area", finding.area);
  write_cause(json, cause);
  json.Key("segments");
  json.counts(finding.segments);
  json.Key("sources");
  json.counts(sources_of(input, finding.segments));
  json.EndObject();
}

void write_findings(JsonWriter& json, const char* key, const SegmentSet& input,
                    const std::vector<Finding>& findings, const std::vector<Cause>& causes) {
  json.Key(key);
  json.StartArray();
  for (std::size_t i = 0; i < findings.size(); ++i)
    write_finding(json, input, findings[i], i < causes.size() ? &causes[i] : nullptr, i + 1);
  json.EndArray();
}

void write_cell(JsonWriter& json, const char* key, bool is_valid, std::size_t cell) {
  json.Key(key);
  if (is_valid)
    json.count(cell);
  else
    json.Null();
}

void write_step(JsonWriter& json, const LadderStep& step) {
  json.StartObject();
  json.Key("squared_radius");
  json.exact(step.squared_radius);
  json.Key("radius");
  json.number(nearest_sqrt(step.squared_radius));
  json.Key("vertices");
  json.count(step.vertices);
  json.Key("edges");
  json.count(step.edges);
  json.Key("faces");
  json.count(step.faces);
  write_cell(json, "vertex", step.vertex.valid(), step.vertex);
  write_cell(json, "other_vertex", step.other_vertex.valid(), step.other_vertex);
  write_cell(json, "edge", step.edge.valid(), step.edge);
  json.EndObject();
}

void write_ladder(JsonWriter& json, const std::optional<ToleranceLadder>& ladder) {
  json.Key("ladder");
  if (!ladder) {
    json.Null();
    return;
  }
  json.StartObject();
  json.Key("vertices");
  json.count(ladder->vertices);
  json.Key("edges");
  json.count(ladder->edges);
  json.Key("faces");
  json.count(ladder->faces);
  json.Key("complete");
  json.Bool(ladder->is_complete);
  json.Key("steps");
  json.StartArray();
  for (const LadderStep& step : ladder->steps) write_step(json, step);
  json.EndArray();
  json.EndObject();
}

void write_right_radii(JsonWriter& json, const std::optional<RightRadii>& radii) {
  json.Key("right_radii");
  if (radii && !radii->empty()) {
    json.StartArray();
    json.number(radii->least);
    json.number(radii->largest);
    json.EndArray();
  } else {
    json.Null();
  }
  json.Key("tried_radii");
  json.StartArray();
  for (const TriedRadius& trial : radii ? radii->tried : std::vector<TriedRadius>()) {
    json.StartObject();
    json.Key("radius");
    json.number(trial.radius);
    json.Key("right");
    json.Bool(trial.is_right);
    json.EndObject();
  }
  json.EndArray();
}

void write_distance(JsonWriter& json, const Rational& squared) {
  json.Key("squared_distance");
  json.exact(squared);
  json.Key("distance");
  json.number(nearest_sqrt(squared));
}

void write_feature_size(JsonWriter& json, const std::optional<FeatureSize>& size) {
  json.Key("feature_size");
  if (!size) {
    json.Null();
    return;
  }
  json.StartObject();
  json.Key("vertex_vertex");
  json.StartObject();
  write_distance(json, size->squared_vertex_vertex);
  json.Key("vertices");
  json.counts(std::vector<VertexId>{size->v, size->w});
  json.EndObject();
  json.Key("vertex_edge");
  if (size->edge.valid()) {
    json.StartObject();
    write_distance(json, size->squared_vertex_edge);
    write_cell(json, "vertex", true, size->vertex);
    write_cell(json, "edge", true, size->edge);
    json.EndObject();
  } else {
    json.Null();
  }
  json.EndObject();
}

}  // namespace

void write_check(JsonWriter& json, const Check& check) {
  json.Key("format");
  json.text("plumbline check 2");
  write_summary(json, check);
  write_findings(json, "findings", check.input, check.comparison.findings, check.causes);
  write_findings(json, "conversion", check.input, check.conversion.findings,
                 check.conversion_causes);
  write_feature_size(json, check.feature_size);
  write_ladder(json, check.ladder);
  write_right_radii(json, check.right_radii);
}

std::string to_json(const Check& check) {
  JsonWriter json;
  json.StartObject();
  write_check(json, check);
  write_input(json, check.input);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
