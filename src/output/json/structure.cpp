// Structures and LAR models as JSON, as read_struct_json reads them.

#include <array>
#include <set>

#include "output/json/writer.hpp"
#include "plumbline/output.hpp"
#include "plumbline/structure.hpp"

namespace plumbline {
namespace {

void write_point(JsonWriter& json, std::span<const Number> coordinates) {
  json.StartArray();
  for (const Number& x : coordinates) json.decimal(x.rational());
  json.EndArray();
}

void write_cells(JsonWriter& json, const Cells& cells) {
  json.StartArray();
  for (std::size_t c = 0; c < cells.size(); ++c) json.counts(cells[c]);
  json.EndArray();
}

/// V and the arrays of cells, by the names that LAR gives them.
void write_members(JsonWriter& json, const LarModel& model) {
  json.Key("V");
  json.StartArray();
  for (std::size_t v = 0; v < model.vertex_count(); ++v) write_point(json, model.vertex(v));
  json.EndArray();
  constexpr std::array<const char*, 3> kNames{"CV", "FV", "EV"};
  const std::size_t count = model.cells.size();
  if (count == 0 || count > kNames.size()) {
    json.Key("cells");
    json.StartArray();
    for (const Cells& cells : model.cells) write_cells(json, cells);
    json.EndArray();
    return;
  }
  const std::size_t first = count == 2 ? 1 : 0;  // (V, CV), (V, FV, EV), (V, CV, FV, EV)
  for (std::size_t k = 0; k < count; ++k) {
    json.Key(kNames.at(first + k));
    write_cells(json, model.cells[k]);
  }
}

class StructWriter {
 public:
  explicit StructWriter(const Structure& structure) : structure_(structure) { name_definitions(); }

  std::string write() && {
    json_.StartObject();
    json_.Key("root");
    json_.text(key(structure_.root));
    json_.Key("y_up");
    json_.Bool(structure_.y_up);
    json_.Key("defs");
    json_.StartObject();
    for (std::size_t s = 0; s < structure_.structs.size(); ++s) define(StructId(s));
    json_.EndObject();
    write_files(json_, structure_.files);
    write_rejected(json_, structure_.rejected);
    write_ledger(json_, structure_.ledger);
    json_.EndObject();
    return json_.take();
  }

 private:
  /// A name for each Struct: its own where no earlier one has it, else one with its number.
  void name_definitions() {
    std::set<std::string> taken;
    for (std::size_t s = 0; s < structure_.structs.size(); ++s) {
      std::string name = valid_utf8(structure_.structs[s].name);
      if (name.empty()) name = "Struct " + std::to_string(s);
      while (!taken.insert(name).second) name += " " + std::to_string(s);
      keys_.push_back(std::move(name));
    }
  }

  const std::string& key(StructId id) const {
    if (id >= keys_.size()) {
      throw Error(ErrorCode::BadInput, "reference to a Struct that does not exist");
    }
    return keys_[id];
  }

  void define(StructId id) {
    const Struct& s = structure_.structs[id];
    json_.key(keys_[id]);
    json_.StartObject();
    if (s.name != keys_[id]) member("name", s.name);
    if (!s.category.empty()) member("category", s.category);
    json_.Key("body");
    json_.StartArray();
    for (const Struct::Item& item : s.body) {
      json_.StartObject();
      std::visit([this](const auto& value) { write_item(value); }, item);
      json_.EndObject();
    }
    json_.EndArray();
    json_.EndObject();
  }

  void write_item(const StructId& id) { member("ref", key(id)); }

  void write_item(const Affine& map) {
    const std::size_t d = map.dimension();
    json_.Key("mat");
    json_.StartArray();
    for (std::size_t i = 0; i < d; ++i) {
      write_point(json_, map.entries().subspan(i * (d + 1), d + 1));
    }
    std::vector<Number> last(d + 1);
    last.back() = Number::decimal(1, 0);
    write_point(json_, last);
    json_.EndArray();
  }

  void write_item(const Model& model) {
    write_source_members(json_, model.source);
    json_.Key("lines");
    json_.StartArray();
    for (std::size_t i = 0; i < model.segments.size(); ++i) {
      json_.StartArray();
      write_point(json_, model.segments.numbers(i).first<2>());
      write_point(json_, model.segments.numbers(i).last<2>());
      json_.EndArray();
    }
    json_.EndArray();
    if (model.rows.empty()) return;
    json_.Key("rows");
    json_.StartArray();
    for (const Model::Row& row : model.rows) {
      json_.StartArray();
      for (const std::uint32_t number : {row.line, row.column, row.segment_count}) {
        json_.count(number);
      }
      if (row.id != 0) json_.text(model.row_ids[row.id - 1]);
      json_.EndArray();
    }
    json_.EndArray();
  }

  void write_item(const LarModel& model) {
    write_source_members(json_, model.source);
    write_members(json_, model);
  }

  void member(const char* name, std::string_view value) {
    json_.Key(name);
    json_.text(value);
  }

  const Structure& structure_;
  std::vector<std::string> keys_;
  JsonWriter json_;
};

}  // namespace

std::string to_json(const Structure& structure) { return StructWriter(structure).write(); }

std::string to_json(const LarModel& model) {
  JsonWriter json;
  json.StartObject();
  write_members(json, model);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
