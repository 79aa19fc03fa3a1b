// LAR structures as JSON: {"root": name, "defs": {name: ...}}.

#include <map>
#include <utility>

#include "plumbline/read.hpp"
#include "read/streams.hpp"
#include "read/struct_json_model.hpp"

namespace plumbline {
namespace {

class StructJsonReader {
 public:
  StructJsonReader(ByteStream& bytes, const ReadOptions& options)
      : tree_(bytes), numbers_(options.shortest_decimals) {
    structure_.files = {bytes.file()};
    structure_.angle_bound = options.angle_bound;
  }

  Structure read() && {
    structure_.y_up = true;
    const JsonValue root = tree_.root();
    expect(root, JsonType::Object, "an object");
    expect_members(root, {"root", "defs", "description", "files", "rejected", "remarks", "ledger",
                          "y_up", "crs", "unit", "layers"});
    if (const JsonValue y_up = root.find("y_up")) structure_.y_up = bool_of(y_up);
    if (const JsonValue crs = root.find("crs")) structure_.crs = string_of(crs);
    if (const JsonValue unit = root.find("unit")) read_unit(unit);
    for_each(root.find("layers"), {"name", "rgb", "hidden"}, [&](const JsonValue& item) {
      Layer layer{member(item, "name"), {}, false};
      if (const JsonValue rgb = item.find("rgb")) layer.rgb = index_of(rgb);
      if (const JsonValue hidden = item.find("hidden")) layer.hidden = bool_of(hidden);
      structure_.layers.push_back(std::move(layer));
    });
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
    read_losses(root);
    numbers_.add_to(structure_.ledger);
    return std::move(structure_);
  }

 private:
  void read_unit(const JsonValue& unit) {
    expect(unit, JsonType::Object, "an object");
    expect_members(unit, {"name", "metres"});
    const JsonValue metres = unit.find("metres");
    if (!metres) unit.fail("no member \"metres\"");
    structure_.unit = LengthUnit{member(unit, "name"), number_of(metres, numbers_).rational()};
    if (sgn(structure_.unit->metres) <= 0) metres.fail("not a length");
  }

  void read_losses(const JsonValue& root) {
    const auto source = [this](const JsonValue& item) {
      return source_of(item, "", structure_.files);
    };
    for_each(root.find("rejected"), {"reason", "text", "harmless"}, [&](const JsonValue& item) {
      const JsonValue harmless = item.find("harmless");
      structure_.rejected.push_back({source(item), member(item, "reason"), member(item, "text"),
                                     harmless && bool_of(harmless)});
    });
    for_each(root.find("remarks"), {"what", "text"}, [&](const JsonValue& item) {
      structure_.remarks.push_back({source(item), member(item, "what"), member(item, "text")});
    });
    for_each(root.find("ledger"), {"what", "bound"}, [&](const JsonValue& item) {
      structure_.ledger.push_back({source(item), member(item, "what"), member(item, "bound")});
    });
  }

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
    result.name = valid_line(def.key());
    if (!body) {
      result.body.push_back(model(def));
    } else {
      expect_members(def, {"type", "name", "category", "body"});
      if (const JsonValue type = def.find("type"); type && type.text() != "Struct") {
        type.fail("a body of something that is not a Struct");
      }
      if (const JsonValue name = def.find("name")) result.name = string_of(name);
      if (const JsonValue category = def.find("category")) result.category = string_of(category);
      expect(body, JsonType::Array, "a list");
      result.body.reserve(body.size());
      for (JsonValue item = body.first(); item; item = item.next()) add(item, result);
    }
    structure_.structs[id] = std::move(result);
  }

  void add(const JsonValue& item, Struct& to) {
    expect(item, JsonType::Object, "an object");
    if (const JsonValue name = item.find("ref")) {
      expect_members(item, {"ref"});
      to.body.emplace_back(referred(name));
    } else if (item.find("op")) {
      to.body.push_back(operation(item));
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

  /// All grids of a file together take no more than twice what one may take: they are a few bytes
  /// of text each.
  Struct::Item model(const JsonValue& value) {
    Struct::Item result = read_model(value, structure_.files, numbers_);
    if (!value.find("shape")) return result;
    const auto& grid = std::get<LarModel>(result);
    grid_numbers_ += grid.coordinates.size();
    for (const Cells& cells : grid.cells) grid_numbers_ += cells.flat().size();
    if (grid_numbers_ > 2 * kMaxGridNumbers) {
      throw Error(ErrorCode::Limit,
                  "grids of more than " + std::to_string(2 * kMaxGridNumbers) + " numbers in all",
                  value.place());
    }
    return result;
  }

  // Maps.

  Struct::Item operation(const JsonValue& item) {
    expect_members(item, {"op", "args", "degrees"});
    const std::string op = string_of(item.find("op"));
    const JsonValue args = item.find("args");
    const JsonValue degrees = item.find("degrees");
    if (op == "r" && degrees && !args) {
      return rotation_item(number_of(degrees, numbers_).rational(),
                           source_of(item, "r", structure_.files));
    }
    if (!args || degrees) item.fail("an operation needs \"args\", or r \"degrees\"");
    const std::vector<Rational> values = rationals_of(args, numbers_);
    if (values.empty()) args.fail("no numbers");
    if (values.size() > kMaxDimension) {
      args.fail("a map of more than " + std::to_string(kMaxDimension) + " dimensions");
    }
    if (op == "t") return translation(values);
    if (op == "s") return scaling(values);
    if (op != "r") item.find("op").fail("not one of the operations t, s and r");
    if (values.size() == 1) {
      return turned(item, rotation_in_radians(values[0], structure_.angle_bound), args);
    }
    if (values.size() != 3) args.fail("a rotation has one number or three");
    return turned(
        item, rotation_in_space({values[0], values[1], values[2]}, structure_.angle_bound), args);
  }

  /// The map, with an entry in the ledger where it stands for another.
  Affine turned(const JsonValue& item, ApproximateAffine rotation, const JsonValue& angle) {
    if (sgn(rotation.bound) != 0) {
      std::string what = angle.is(JsonType::Array) ? std::string() : valid_line(angle.text());
      for (JsonValue v = angle.first(); v; v = v.next()) {
        what += (what.empty() ? "" : ", ") + valid_line(v.text());
      }
      structure_.ledger.push_back({source_of(item, "r", structure_.files), "r(" + what + ")",
                                   shortest_text(nearest_double(rotation.bound)) + " rad"});
    }
    return std::move(rotation.map);
  }

  /// A matrix in homogeneous coordinates, the last one 1.
  Affine matrix(const JsonValue& rows) {
    expect(rows, JsonType::Array, "a list of rows");
    if (rows.size() < 2) rows.fail("a matrix of less than two rows");
    if (rows.size() > kMaxDimension + 1) {
      rows.fail("a matrix of more than " + std::to_string(kMaxDimension) + " dimensions");
    }
    Affine map(rows.size() - 1);
    std::size_t i = 0;
    for (JsonValue row = rows.first(); row; row = row.next(), ++i) {
      const std::vector<Rational> entries = rationals_of(row, numbers_);
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

  // Sources.

  /// What "files" lists, then this file.
  void read_files(const JsonValue& files) {
    const std::string own = std::move(structure_.files.front());
    structure_.files.clear();
    if (files) expect(files, JsonType::Array, "a list of names");
    for (JsonValue file = files ? files.first() : files; file; file = file.next()) {
      structure_.files.push_back(string_of(file));
    }
    structure_.files.push_back(own);
  }

  static std::string member(const JsonValue& object, const char* name) {
    const JsonValue value = object.find(name);
    if (!value) object.fail("no member \"" + std::string(name) + "\"");
    return string_of(value);
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
  Numbers numbers_;
  Structure structure_;
  std::uint64_t grid_numbers_ = 0;
  std::map<std::string, StructId, std::less<>> ids_;
  std::vector<std::pair<JsonValue, StructId>> waiting_;  ///< definitions, in the order of reading
};

}  // namespace

Structure read_struct_json(ByteStream& bytes, const ReadOptions& options) {
  Structure structure = StructJsonReader(bytes, options).read();
  try {
    dimension(structure);  // finds cycles and mixed dimensions
  } catch (const Error& error) {
    if (!error.place().file.empty()) throw;
    throw Error(error.code(), error.message(), {bytes.file(), 0, 0}, error.offending_text());
  }
  return structure;
}

Structure read_struct_json(std::string_view text, const std::string& file_name,
                           const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_struct_json(bytes, options);
}

}  // namespace plumbline
