// The report as JSON; documented in docs/json.md.

#include "plumbline/report.hpp"
#include "report/verdict.hpp"
#include "write/json_writer.hpp"

namespace plumbline {
namespace {

void write_counts(JsonWriter& json, const Counts& counts) {
  json.StartObject();
  for (const CountRow& row : count_rows()) {
    json.Key(row.name);
    json.count(counts.*row.member);
  }
  json.EndObject();
}

void write_summary(JsonWriter& json, const Check& check) {
  const Crosscheck& c = check.crosscheck;
  json.Key("verdict");
  json.text(c.agree() ? "agree" : "disagree");
  json.Key("float_valid");
  json.Bool(c.float_valid);
  json.Key("exact");
  json.Bool(check.input.ledger.empty());
  json.Key("radius");
  if (check.radius)
    json.number(*check.radius);
  else
    json.Null();
  json.Key("tolerance");
  json.number(c.tolerance);
  json.Key("largest_displacement");
  json.number(c.largest_displacement);
  json.Key("counts");
  json.StartObject();
  json.Key("exact");
  write_counts(json, c.exact_counts);
  json.Key("float");
  write_counts(json, c.float_counts);
  json.EndObject();
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

void write_finding(JsonWriter& json, const SegmentSet& input, const Finding& finding,
                   std::size_t number) {
  json.StartObject();
  json.Key("number");
  json.count(number);
  json.Key("kind");
  json.text(to_text(finding.kind));
  json.Key("disagreement");
  json.text(to_text(finding.disagreement));
  json.Key("message");
  json.text(finding.message);
  json.Key("where");
  if (finding.kind == CellKind::Complex) {
    json.Null();
  } else {
    json.place(finding.where);
  }
  json.Key("exact_cells");
  json.counts(finding.exact_cells);
  json.Key("float_cells");
  json.counts(finding.float_cells);
  json.Key("distance");
  if (finding.distance)
    json.number(*finding.distance);
  else
    json.Null();
  json.Key("segments");
  json.counts(finding.segments);
  json.Key("sources");
  json.counts(sources_of(input, finding.segments));
  json.EndObject();
}

}  // namespace

std::string report_json(const Check& check) {
  JsonWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline check 1");
  write_summary(json, check);
  json.Key("findings");
  json.StartArray();
  for (std::size_t i = 0; i < check.crosscheck.findings.size(); ++i)
    write_finding(json, check.input, check.crosscheck.findings[i], i + 1);
  json.EndArray();
  write_input(json, check.input);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
