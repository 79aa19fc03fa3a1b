// LAR structures as JSON: {"root": name, "defs": {name: ...}}.

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include "plumbline/read.hpp"
#include "read/attribute.hpp"
#include "read/json_tree.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

/// The members that every item may have.
constexpr std::array<std::string_view, 6> kSource{"file",    "line", "column",
                                                  "element", "id",   "path"};

/// The other members that an object may have; more are refused.
void expect_members(const JsonValue& object, std::initializer_list<std::string_view> known) {
  const auto is_in = [](std::string_view key, const auto& names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  for (JsonValue member = object.first(); member; member = member.next()) {
    if (is_in(member.key(), known) || is_in(member.key(), kSource)) continue;
    throw Error(ErrorCode::BadInput, "a member that is not understood here", member.place(),
                printable(member.key()));
  }
}

void expect(const JsonValue& value, JsonType type, const char* what) {
  if (!value.is(type)) value.fail("not " + std::string(what));
}

class StructJsonReader {
 public:
  explicit StructJsonReader(ByteStream& bytes) : tree_(bytes) { structure_.files = {bytes.file()}; }

  Structure read(double angle_bound) && {
    angle_bound_ = angle_bound;
    structure_.y_up = true;
    const JsonValue root = tree_.root();
    expect(root, JsonType::Object, "an object");
    expect_members(root, {"root", "defs", "description", "files", "rejected", "ledger"});
    read_files(root.find("files"));
    const JsonValue defs = root.find("defs");
    if (!defs) root.fail("no member \"defs\"");
    expect(defs, JsonType::Object, "an object");
    for (JsonValue def = defs.first(); def; def = def.next()) {
      ids_.emplace(def.key(), new_struct());
      waiting_.emplace_back(def, StructId(structure_.structs.size() - 1));
    }
    const JsonValue name = root.find("root");
    if (!name) root.fail("no member \"root\"");
    structure_.root = referred(name);
    for (std::size_t i = 0; i < waiting_.size(); ++i) {  // grows on the way
      const auto [def, id] = waiting_[i];
      define(def, id);
    }
    for_each(root.find("rejected"), {"reason", "text"}, [this](const JsonValue& item) {
      structure_.rejected.push_back(
          {source(item, ""), member(item, "reason"), member(item, "text")});
    });
    for_each(root.find("ledger"), {"what", "bound"}, [this](const JsonValue& item) {
      structure_.ledger.push_back({source(item, ""), member(item, "what"), member(item, "bound")});
    });
    return std::move(structure_);
  }

 private:
  StructId new_struct() {
    structure_.structs.emplace_back();
    return StructId(structure_.structs.size() - 1);
  }

  StructId referred(const JsonValue& name) const {
    expect(name, JsonType::String, "the name of a definition");
    const auto found = ids_.find(name.text());
    if (found == ids_.end()) name.fail("no definition has this name");
    return found->second;
  }

  /// What a definition says: a Struct, or a model, which is a Struct of nothing else.
  void define(const JsonValue& def, StructId id) {
    expect(def, JsonType::Object, "an object");
    const JsonValue body = def.find("body");
    Struct result;
    result.name = def.key();
    if (!body) {
      result.body.push_back(model(def));
    } else {
      expect_members(def, {"type", "name", "category", "body"});
      if (const JsonValue type = def.find("type"); type && type.text() != "Struct") {
        type.fail("a body of something that is not a Struct");
      }
      if (const JsonValue name = def.find("name")) result.name = string(name);
      if (const JsonValue category = def.find("category")) result.category = string(category);
      expect(body, JsonType::Array, "a list");
      result.body.reserve(body.size());
      for (JsonValue item = body.first(); item; item = item.next()) add(item, result);
    }
    structure_.structs[id] = std::move(result);
  }

  static std::string string(const JsonValue& value) {
    expect(value, JsonType::String, "a string");
    return std::string(value.text());
  }

  void add(const JsonValue& item, Struct& to) {
    expect(item, JsonType::Object, "an object");
    if (const JsonValue name = item.find("ref")) {
      expect_members(item, {"ref"});
      to.body.emplace_back(referred(name));
    } else if (item.find("op")) {
      to.body.emplace_back(operation(item));
    } else if (const JsonValue rows = item.find("mat")) {
      expect_members(item, {"mat"});
      to.body.emplace_back(matrix(rows));
    } else if (item.find("body")) {
      const StructId id = new_struct();
      waiting_.emplace_back(item, id);
      to.body.emplace_back(id);
    } else {
      to.body.push_back(model(item));
    }
  }

  // Numbers.

  Number number(const JsonValue& value) {
    if (!value.is(JsonType::Number) && !value.is(JsonType::String)) value.fail("not a number");
    try {
      return numbers_.parse(value.text());
    } catch (const Unusable& problem) {
      value.fail(problem.reason);
    }
  }

  std::vector<Rational> rationals(const JsonValue& list) {
    expect(list, JsonType::Array, "a list of numbers");
    std::vector<Rational> result;
    for (JsonValue v = list.first(); v; v = v.next()) result.push_back(number(v).rational());
    return result;
  }

  static std::uint32_t index(const JsonValue& value) {
    std::uint32_t result = 0;
    const std::string_view text = value.text();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (!value.is(JsonType::Number) || error != std::errc() || end != text.data() + text.size()) {
      value.fail("not a whole number from 0 to 2^32 - 1");
    }
    return result;
  }

  // Maps.

  Affine operation(const JsonValue& item) {
    expect_members(item, {"op", "args", "degrees"});
    const std::string op = string(item.find("op"));
    const JsonValue args = item.find("args");
    const JsonValue degrees = item.find("degrees");
    if (op == "r" && degrees && !args)
      return turned(item, rotation_by(degrees), degrees, " degrees");
    if (!args || degrees) item.fail("an operation needs \"args\", or r \"degrees\"");
    const std::vector<Rational> values = rationals(args);
    if (values.empty()) args.fail("no numbers");
    if (op == "t") return translation(values);
    if (op == "s") return scaling(values);
    if (op != "r") item.find("op").fail("not one of the operations t, s and r");
    if (values.size() == 1) return turned(item, rotation_in_radians(values[0], angle_bound_), args);
    if (values.size() != 3) args.fail("a rotation has one number or three");
    return turned(item, rotation_in_space({values[0], values[1], values[2]}, angle_bound_), args);
  }

  ApproximateAffine rotation_by(const JsonValue& degrees) {
    return rotation(number(degrees).rational(), angle_bound_);
  }

  /// The map, with an entry in the ledger where it stands for another.
  Affine turned(const JsonValue& item, ApproximateAffine rotation, const JsonValue& angle,
                const char* unit = "") {
    if (sgn(rotation.bound) != 0) {
      std::string what = angle.is(JsonType::Array) ? std::string() : std::string(angle.text());
      for (JsonValue v = angle.first(); v; v = v.next()) {
        what += (what.empty() ? "" : ", ") + std::string(v.text());
      }
      structure_.ledger.push_back({source(item, "r"), "r(" + what + ")" + unit,
                                   shortest_text(nearest_double(rotation.bound)) + " rad"});
    }
    return std::move(rotation.map);
  }

  /// A matrix in homogeneous coordinates, the last one 1.
  Affine matrix(const JsonValue& rows) {
    expect(rows, JsonType::Array, "a list of rows");
    if (rows.size() < 2) rows.fail("a matrix of less than two rows");
    Affine map(rows.size() - 1);
    std::size_t i = 0;
    for (JsonValue row = rows.first(); row; row = row.next(), ++i) {
      const std::vector<Rational> entries = rationals(row);
      if (entries.size() != rows.size()) row.fail("a matrix that is not square");
      for (std::size_t j = 0; j < entries.size(); ++j) {
        if (i < map.dimension()) {
          map(i, j) = entries[j];
        } else if (entries[j] != (j == i ? 1 : 0)) {
          row.fail("the last row of a matrix is not 0 ... 0 1");
        }
      }
    }
    return map;
  }

  // Models.

  Struct::Item model(const JsonValue& value) {
    if (value.find("lines")) return lines(value);
    if (value.find("shape")) return grid(value);
    expect_members(value, {"type", "V", "CV", "FV", "EV", "cells"});
    LarModel result;
    result.source = source(value, "model");
    read_vertices(value, result);
    read_cells(value, result);
    if (result.cells.empty()) value.fail("a model without cells");
    check(result, structure_.files);
    return result;
  }

  void read_vertices(const JsonValue& model, LarModel& result) {
    const JsonValue vertices = model.find("V");
    if (!vertices) model.fail("neither a Struct, a map, a reference nor a model");
    expect(vertices, JsonType::Array, "a list of points");
    bool is_first = true;
    for (JsonValue vertex = vertices.first(); vertex; vertex = vertex.next()) {
      expect(vertex, JsonType::Array, "a point");
      if (vertex.size() == 0) vertex.fail("a point without coordinates");
      if (is_first) result.dimension = vertex.size();
      is_first = false;
      if (vertex.size() != result.dimension) vertex.fail("points of different dimensions");
      for (JsonValue x = vertex.first(); x; x = x.next()) result.coordinates.push_back(number(x));
    }
  }

  void read_cells(const JsonValue& model, LarModel& result) {
    if (const JsonValue arrays = model.find("cells")) {
      expect(arrays, JsonType::Array, "a list of arrays of cells");
      for (JsonValue array = arrays.first(); array; array = array.next()) {
        result.cells.push_back(cells(array));
      }
    }
    for (const char* name : {"CV", "FV", "EV"}) {
      if (const JsonValue array = model.find(name)) result.cells.push_back(cells(array));
    }
  }

  static Cells cells(const JsonValue& array) {
    expect(array, JsonType::Array, "a list of cells");
    Cells result;
    std::vector<std::uint32_t> vertices;
    for (JsonValue cell = array.first(); cell; cell = cell.next()) {
      expect(cell, JsonType::Array, "a cell, a list of vertices");
      vertices.clear();
      for (JsonValue v = cell.first(); v; v = v.next()) vertices.push_back(index(v));
      result.push_back(vertices);
    }
    return result;
  }

  LarModel grid(const JsonValue& value) {
    expect_members(value, {"type", "shape", "skeletons", "boundary"});
    const auto flag = [&](const char* name) {
      const JsonValue member = value.find(name);
      if (member) expect(member, JsonType::Bool, "true or false");
      return member && member.text() == "true";
    };
    std::vector<std::uint32_t> shape;
    const JsonValue extents = value.find("shape");
    expect(extents, JsonType::Array, "a list of whole numbers");
    for (JsonValue extent = extents.first(); extent; extent = extent.next()) {
      shape.push_back(index(extent));
    }
    if (shape.empty()) extents.fail("a grid of dimension 0");
    const bool boundary = flag("boundary");
    LarModel result = cuboids(shape, boundary || flag("skeletons"));
    if (boundary) result = boundary_model(result);
    result.source = source(value, "cuboids");
    return result;
  }

  Model lines(const JsonValue& value) {
    expect_members(value, {"type", "lines", "rows"});
    Model result;
    result.source = source(value, "lines");
    const JsonValue list = value.find("lines");
    expect(list, JsonType::Array, "a list of lines");
    for (JsonValue line = list.first(); line; line = line.next()) {
      std::array<Number, 4> x;
      std::size_t count = 0;
      expect(line, JsonType::Array, "a line, a list of two points");
      for (JsonValue point = line.first(); point; point = point.next()) {
        expect(point, JsonType::Array, "a point");
        if (point.size() != 2 || count == x.size()) line.fail("not two points of the plane");
        for (JsonValue c = point.first(); c; c = c.next()) x.at(count++) = number(c);
      }
      if (count != x.size()) line.fail("not two points of the plane");
      result.segments.push_back({std::move(x[0]), std::move(x[1])},
                                {std::move(x[2]), std::move(x[3])});
    }
    if (const JsonValue rows = value.find("rows")) read_rows(rows, result);
    return result;
  }

  static void read_rows(const JsonValue& rows, Model& model) {
    expect(rows, JsonType::Array, "a list of lines and columns");
    if (rows.size() != model.segments.size()) rows.fail("not as many rows as lines");
    for (JsonValue row = rows.first(); row; row = row.next()) {
      expect(row, JsonType::Array, "a line and a column");
      if (row.size() != 2) row.fail("not a line and a column");
      model.rows.push_back({index(row.first()), index(row.first().next())});
    }
  }

  // Sources.

  /// What "files" lists, then this file.
  void read_files(const JsonValue& files) {
    const std::string own = std::move(structure_.files.front());
    structure_.files.clear();
    if (files) expect(files, JsonType::Array, "a list of names");
    for (JsonValue file = files ? files.first() : files; file; file = file.next()) {
      structure_.files.push_back(string(file));
    }
    structure_.files.push_back(own);
  }

  /// The members of a source, of which each may be missing. Without a line the place of the value
  /// itself, under its id or the name of its definition.
  Source source(const JsonValue& value, const char* element) const {
    const Place place = value.place();
    Source result{own_file(), place.line, place.column, element, std::string(value.key()), {}};
    if (const JsonValue line = value.find("line")) {
      result = {own_file(), index(line), 0, element, {}, {}};
    }
    if (const JsonValue file = value.find("file")) {
      result.file = index(file);
      if (result.file >= structure_.files.size()) file.fail("no file has this number");
    }
    if (const JsonValue column = value.find("column")) result.column = index(column);
    if (const JsonValue name = value.find("element")) result.element = string(name);
    if (const JsonValue id = value.find("id")) result.id = string(id);
    if (const JsonValue path = value.find("path")) result.path = string(path);
    return result;
  }

  std::uint32_t own_file() const { return static_cast<std::uint32_t>(structure_.files.size() - 1); }

  static std::string member(const JsonValue& object, const char* name) {
    const JsonValue value = object.find(name);
    if (!value) object.fail("no member \"" + std::string(name) + "\"");
    return string(value);
  }

  /// Every object of a list of sources with other members.
  template <class Take>
  static void for_each(const JsonValue& list, std::initializer_list<std::string_view> members,
                       Take take) {
    if (!list) return;
    expect(list, JsonType::Array, "a list");
    for (JsonValue item = list.first(); item; item = item.next()) {
      expect(item, JsonType::Object, "an object");
      expect_members(item, members);
      take(item);
    }
  }

  JsonTree tree_;
  Structure structure_;
  Numbers numbers_;
  double angle_bound_ = kAngleBound;
  std::map<std::string, StructId, std::less<>> ids_;
  std::vector<std::pair<JsonValue, StructId>> waiting_;  ///< definitions, in the order of reading
};

}  // namespace

Structure read_struct_json(ByteStream& bytes, const ReadOptions& options) {
  return StructJsonReader(bytes).read(options.angle_bound);
}

Structure read_struct_json(std::string_view text, const std::string& file_name,
                           const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_struct_json(bytes, options);
}

}  // namespace plumbline
