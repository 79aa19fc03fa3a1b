// The diagnosis as JSON; documented in docs/json.md.

#include "output/json/diagnosis.hpp"

#include <string>

#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

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

void write_defect(JsonWriter& json, const SegmentSet& input, const Defect& defect,
                  std::size_t number) {
  json.StartObject();
  json.Key("number");
  json.count(number);
  json.Key("kind");
  json.text(to_text(defect.kind));
  json.Key("message");
  json.text(defect.message);
  json.Key("where");
  json.place(defect.where);
  json.Key("size");
  json.number(defect.size);
  write_exact(json, "squared_size", defect.squared_size);
  write_exact(json, "area", defect.area);
  json.Key("proposed_tolerance");
  if (defect.proposed_tolerance)
    json.number(*defect.proposed_tolerance);
  else
    json.Null();
  json.Key("vertices");
  json.counts(defect.vertices);
  json.Key("edges");
  json.counts(defect.edges);
  json.Key("face");
  if (defect.face.valid())
    json.count(defect.face);
  else
    json.Null();
  json.Key("segments");
  json.counts(defect.segments);
  json.Key("sources");
  json.counts(sources_of(input, defect.segments));
  json.EndObject();
}

void write_tolerances(JsonWriter& json, const Diagnosis& diagnosis) {
  json.Key("tolerances");
  json.StartArray();
  for (const ToleranceEffect& effect : diagnosis.tolerances) {
    json.StartObject();
    json.Key("tolerance");
    json.number(effect.tolerance);
    json.Key("mended");
    json.count(effect.mended);
    json.Key("spares_detail");
    json.Bool(effect.spares_detail);
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace

void write_diagnosis(JsonWriter& json, const Diagnosis& diagnosis, const SegmentSet& input) {
  write_exact(json, "within", diagnosis.within);
  json.Key("counts");
  json.StartObject();
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    json.key(to_text(static_cast<DefectKind>(kind)));
    json.count(diagnosis.found[kind]);
  }
  json.EndObject();
  json.Key("loose_ends");
  json.count(diagnosis.tips);
  json.Key("cut_short");
  json.count(diagnosis.cut_short);
  write_exact(json, "squared_detail", diagnosis.squared_detail);
  write_tolerances(json, diagnosis);
  json.Key("defects");
  json.StartArray();
  for (std::size_t i = 0; i < diagnosis.defects.size(); ++i)
    write_defect(json, input, diagnosis.defects[i], i + 1);
  json.EndArray();
}

std::string to_json(const Diagnosis& diagnosis, const SegmentSet& input) {
  JsonWriter json;
  json.StartObject();
  json.Key("format");
  json.text("plumbline diagnosis 1");
  json.Key("exact");
  json.Bool(input.ledger.empty());
  write_diagnosis(json, diagnosis, input);
  write_input(json, input);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
