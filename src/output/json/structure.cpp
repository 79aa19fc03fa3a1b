// Structures and LAR models as JSON, as read_struct_json reads them.

#include "plumbline/structure.hpp"

#include <array>
#include <set>

#include "output/json/input.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto point(std::span<const Number> coordinates) {
  return list(coordinates, [](const Number& x) { return decimal(x.rational()); });
}

auto cell_list(const Cells& of_one_dimension) {
  return list(of_one_dimension.size(),
              [&of_one_dimension](std::size_t c) { return of_one_dimension[c]; });
}

/// V and the arrays of cells, by the names that LAR gives them.
auto model_members(const LarModel& model) {
  constexpr std::array<const char*, 3> kNames{"CV", "FV", "EV"};
  const std::size_t count = model.cells.size();
  const bool have_names = count > 0 && count <= kNames.size();
  const std::size_t first = count == 2 ? 1 : 0;  // (V, CV), (V, FV, EV), (V, CV, FV, EV)
  return members(
      member("V", list(model.vertex_count(),
                       [&model](std::size_t v) { return point(model.vertex(v)); })),
      when(!have_names, [&model] { return member("cells", list(model.cells, cell_list)); }),
      each(Numbers(0, have_names ? count : 0), [&model, kNames, first](std::size_t k) {
        return member(kNames.at(first + k), cell_list(model.cells[k]));
      }));
}

/// The rows of the matrix, that below the map's own included.
auto map_member(const Affine& map) {
  const std::size_t width = map.dimension() + 1;
  std::vector<Number> last(width);
  last.back() = Number::decimal(1, 0);
  return member("mat", list(width, [&map, width, last = std::move(last)](std::size_t i) {
                  return point(i + 1 < width ? map.entries().subspan(i * width, width) : last);
                }));
}

using Row = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
using RowWithId = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string_view>;

/// A text that stands somewhere, or the name of an element; in a table of which row.
auto label(const Model::Text& text) {
  return object(member("text", text.text),
                when(text.place.has_value(),
                     [&text] {
                       const auto& [x, y] = *text.place;
                       return member("place",
                                     std::tuple(decimal(x.rational()), decimal(y.rational())));
                     }),
                when(text.height > 0, [&text] { return member("height", text.height); }),
                when(text.row > 0, [&text] { return member("row", text.row); }));
}

/// What a drawing unit is and which layers there are, where the files say it.
Part drawing_members(const Structure& structure) {
  const auto layer = [](const Layer& l) {
    return object(member("name", l.name),
                  when(l.rgb.has_value(), [&l] { return member("rgb", *l.rgb); }),
                  when(l.hidden, [] { return member("hidden", true); }));
  };
  const auto unit = [&structure] {
    return member("unit", object(member("name", structure.unit->name),
                                 member("metres", decimal(structure.unit->metres))));
  };
  const auto layers = [&structure, layer] {
    return member("layers", list(structure.layers, layer));
  };
  return part_of(
      members(when(structure.unit.has_value(), unit), when(!structure.layers.empty(), layers)));
}

auto lines_members(const Model& model) {
  const auto line = [&model](std::size_t i) {
    const auto numbers = model.segments.numbers(i);
    return std::tuple(point(numbers.first<2>()), point(numbers.last<2>()));
  };
  const auto row = [&model](const Model::Row& r) -> std::variant<Row, RowWithId> {
    if (r.id == 0) return Row{r.line, r.column, r.segment_count};
    return RowWithId{r.line, r.column, r.segment_count, model.row_ids[r.id - 1]};
  };
  return members(
      source_members(model.source), member("lines", list(model.segments.size(), line)),
      when(!model.rows.empty(), [&model, row] { return member("rows", list(model.rows, row)); }),
      when(!model.rings.empty(),
           [&model] {
             return member("rings", list(model.rings, [](const Ring& ring) {
                             return std::tuple(ring.first, ring.count,
                                               std::string_view(to_text(ring.role)));
                           }));
           }),
      when(!model.labels.empty(),
           [&model] { return member("labels", list(model.labels, label)); }));
}

/// A name for each Struct: its own where no earlier one has it, else one with its number.
std::vector<std::string> names(const Structure& structure) {
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (std::size_t s = 0; s < structure.structs.size(); ++s) {
    std::string name = valid_utf8(structure.structs[s].name);
    if (name.empty()) name = "Struct " + std::to_string(s);
    while (!taken.insert(name).second) name += " " + std::to_string(s);
    result.push_back(std::move(name));
  }
  return result;
}

/// The items of Structs.
struct Items {
  const std::vector<std::string>& names;

  const std::string& name(StructId id) const {
    if (id < names.size()) return names[id];
    throw Error(ErrorCode::BadInput, "reference to a Struct that does not exist");
  }
  Part operator()(const StructId& id) const { return part_of(member("ref", name(id))); }
  Part operator()(const Affine& map) const { return part_of(map_member(map)); }
  Part operator()(const Turn& turn) const {
    return part_of(members(member("op", "r"), member("degrees", decimal(turn.degrees)),
                           source_members(turn.source)));
  }
  Part operator()(const Model& model) const { return part_of(lines_members(model)); }
  Part operator()(const LarModel& model) const {
    return part_of(members(source_members(model.source), model_members(model)));
  }
};

auto definition(const Struct& s, const std::string& name, const Items& items) {
  return object(when(s.name != name, [&s] { return member("name", s.name); }),
                when(!s.category.empty(), [&s] { return member("category", s.category); }),
                member("body", list(s.body, [items](const Struct::Item& item) {
                         return object(std::visit(items, item));
                       })));
}

}  // namespace
}  // namespace json

std::string to_json(const Structure& structure) {
  using namespace json;
  const std::vector<std::string> keys = names(structure);
  const Items items{keys};
  return document(object(member("root", items.name(structure.root)), member("y_up", structure.y_up),
                         crs_member(structure.crs), drawing_members(structure),
                         member("defs", object(each(Numbers(0, keys.size()),
                                                    [&](std::size_t s) {
                                                      return member(keys[s],
                                                                    definition(structure.structs[s],
                                                                               keys[s], items));
                                                    }))),
                         member("files", structure.files),
                         losses(structure.rejected, structure.remarks, structure.ledger)));
}

std::string to_json(const LarModel& model) {
  return json::document(json::object(json::model_members(model)));
}

}  // namespace plumbline
