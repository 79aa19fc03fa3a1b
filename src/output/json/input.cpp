#include "output/json/writer.hpp"

namespace plumbline {

void write_source_members(JsonWriter& json, const Source& source) {
  json.Key("file");
  json.count(source.file);
  json.Key("line");
  json.count(source.line);
  json.Key("column");
  json.count(source.column);
  json.Key("element");
  json.text(source.element);
  json.Key("id");
  json.text(source.id);
  json.Key("path");
  json.text(source.path);
}

void write_files(JsonWriter& json, const std::vector<std::string>& files) {
  json.Key("files");
  json.StartArray();
  for (const std::string& file : files) json.text(file);
  json.EndArray();
}

void write_input(JsonWriter& json, const SegmentSet& input) {
  write_files(json, input.files);
  json.Key("sources");
  json.StartArray();
  for (const Source& source : input.sources) {
    json.StartObject();
    write_source_members(json, source);
    json.EndObject();
  }
  json.EndArray();
  json.Key("segments");
  json.StartArray();
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    json.StartObject();
    json.Key("source");
    json.count(input.segment_source[s]);
    json.Key("from");
    json.point(input.segments[s].a);
    json.Key("to");
    json.point(input.segments[s].b);
    json.EndObject();
  }
  json.EndArray();
  write_rejected(json, input.rejected);
  write_ledger(json, input.ledger);
}

void write_rejected(JsonWriter& json, const std::vector<Rejected>& rejected) {
  json.Key("rejected");
  json.StartArray();
  for (const Rejected& item : rejected) {
    json.StartObject();
    write_source_members(json, item.source);
    json.Key("reason");
    json.text(item.reason);
    json.Key("text");
    json.text(item.text);
    json.EndObject();
  }
  json.EndArray();
}

void write_ledger(JsonWriter& json, const std::vector<Replacement>& ledger) {
  json.Key("ledger");
  json.StartArray();
  for (const Replacement& item : ledger) {
    json.StartObject();
    write_source_members(json, item.source);
    json.Key("what");
    json.text(item.what);
    json.Key("bound");
    json.text(item.bound);
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace plumbline
