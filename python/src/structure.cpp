// Hierarchies of Structs, and what they come to.

#include "plumbline/structure.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>

#include <string>
#include <tuple>
#include <utility>

#include "core.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "structure_making.hpp"

namespace plumbline::python {
namespace {

const Struct& struct_at(const Structure& structure, std::size_t i) {
  if (i >= structure.structs.size()) throw nb::index_error("there are fewer structs");
  return structure.structs[i];
}

/// An item of a body; a reference as the number of its Struct.
nb::object item(nb::handle self, std::size_t i, std::size_t k) {
  const Struct& s = struct_at(nb::cast<const Structure&>(self), i);
  if (k >= s.body.size()) throw nb::index_error("there are fewer items");
  return std::visit(
      [&](const auto& held) -> nb::object {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, StructId>) {
          return nb::int_(static_cast<std::size_t>(held));
        } else {
          return nb::cast(held, nb::rv_policy::reference_internal, self);
        }
      },
      s.body[k]);
}

/// What a body holds: elements of drawings, segments of these, models, maps; and the Structs that
/// it refers to, one by one.
struct Contents {
  std::size_t elements = 0, segments = 0, models = 0, maps = 0;
  std::vector<StructId> structs;
};

Contents contents(const Structure& structure, std::size_t i) {
  Contents result;
  for (const Struct::Item& held : struct_at(structure, i).body) {
    if (const auto* element = std::get_if<Model>(&held)) {
      result.elements += element->rows.empty() ? 1 : element->rows.size();
      result.segments += element->segments.size();
    } else if (std::holds_alternative<LarModel>(held)) {
      ++result.models;
    } else if (const auto* id = std::get_if<StructId>(&held)) {
      result.structs.push_back(*id);
    } else {
      ++result.maps;
    }
  }
  return result;
}

/// The models under their maps, in traversal order.
std::vector<LarModel> models(const Structure& structure) {
  std::vector<LarModel> result;
  std::size_t words = 0;
  for (Traversal t(structure); t.next();) {
    const auto* model = std::get_if<LarModel>(&t.model());
    result.push_back(apply(t.map(), model ? *model : lar_model(std::get<Model>(t.model()))));
    words += 2 * result.back().coordinates.size();
    for (const Cells& cells : result.back().cells) words += cells.flat().size();
    if (words > kMaxEvaluatedWords) {
      throw Error(ErrorCode::Limit, "the models of the structure take too much memory");
    }
  }
  return result;
}

Structure with_root(const Structure& structure, std::size_t root) {
  struct_at(structure, root);
  dimension(structure);  // refuses references that lead nowhere
  Structure result = structure;
  result.structs.clear();
  result.root = StructId(0);
  std::vector<StructId> number(structure.structs.size());
  std::vector<std::size_t> reached{root};
  number[root] = StructId(0);
  for (std::size_t r = 0; r < reached.size(); ++r) {
    Struct copy = structure.structs[reached[r]];
    for (Struct::Item& held : copy.body) {
      auto* id = std::get_if<StructId>(&held);
      if (id == nullptr) continue;
      if (!number[*id].valid()) {
        number[*id] = StructId(reached.size());
        reached.push_back(*id);
      }
      *id = number[*id];
    }
    result.structs.push_back(std::move(copy));
  }
  return result;
}

using Corners = std::pair<std::vector<Rational>, std::vector<Rational>>;

std::optional<Corners> box_of(const Structure& structure) {
  const std::optional<Box> found = box(structure);
  if (!found) return std::nullopt;
  Corners corners;
  for (const Number& number : found->low) corners.first.push_back(number.rational());
  for (const Number& number : found->high) corners.second.push_back(number.rational());
  return corners;
}

void bind_reading(nb::class_<Structure>& type) {
  type.def_ro("files", &Structure::files)
      .def_ro("rejected", &Structure::rejected)
      .def_ro("remarks", &Structure::remarks)
      .def_ro("ledger", &Structure::ledger)
      .def_ro("layers", &Structure::layers)
      .def_ro("crs", &Structure::crs)
      .def_ro("unit", &Structure::unit)
      .def_ro("root", &Structure::root, "The number of the Struct that is the whole.")
      .def("__len__", [](const Structure& s) { return s.structs.size(); })
      .def(
          "name", [](const Structure& s, std::size_t i) { return struct_at(s, i).name; },
          nb::arg("i"))
      .def(
          "category", [](const Structure& s, std::size_t i) { return struct_at(s, i).category; },
          nb::arg("i"))
      .def(
          "body_size",
          [](const Structure& s, std::size_t i) { return struct_at(s, i).body.size(); },
          nb::arg("i"))
      .def("item", &item, nb::arg("i"), nb::arg("k"),
           nb::sig("def item(self, i: int, k: int) -> Affine | Turn | Element | LarModel | int"),
           "An item of a body; a reference as the number of its Struct.")
      .def("contents", &contents, nb::arg("i"));
  define_equality(type);
}

void bind_questions(nb::class_<Structure>& type) {
  type.def(
          "evaluate",
          [](const Structure& s, bool doubles) {
            return doubles ? evaluate_rounded(s) : evaluate(s);
          },
          nb::arg("doubles"), nb::call_guard<nb::gil_scoped_release>(),
          "Its segments; with `doubles` of what its numbers are as nearest doubles.")
      .def("drawn", &drawn, nb::call_guard<nb::gil_scoped_release>(),
           "Its segments; of space those of an oblique view.")
      .def(
          "dimension", [](const Structure& s) { return dimension(s); },
          nb::call_guard<nb::gil_scoped_release>())
      .def(
          "instance_count", [](const Structure& s) { return instance_count(s); },
          nb::call_guard<nb::gil_scoped_release>())
      .def("models", &models, nb::call_guard<nb::gil_scoped_release>(),
           "All models under their maps, as often as they are referred to.")
      .def("box", &box_of, nb::call_guard<nb::gil_scoped_release>(), "Its corners.")
      .def(
          "to_lar",
          [](const Structure& s, std::optional<int> decimals, bool merge_cells) {
            return struct_to_lar(s, {decimals, merge_cells});
          },
          nb::arg("decimals").none(), nb::arg("merge_cells"),
          nb::call_guard<nb::gil_scoped_release>(), "All of it as one model.")
      .def("of_category", &only, nb::arg("category"), nb::call_guard<nb::gil_scoped_release>(),
           "What stands within Structs of this category.")
      .def(
          "embedded", [](const Structure& s, int k) { return embed(s, k); }, nb::arg("k"),
          nb::call_guard<nb::gil_scoped_release>(), "With k more dimensions, or -k fewer.")
      .def(
          "rounded", [](const Structure& s) { return rounded(s); },
          nb::call_guard<nb::gil_scoped_release>(), "With every number as its nearest double.")
      .def(
          "replaced", [](const Structure& s) { return replaced_rotations(s); },
          nb::call_guard<nb::gil_scoped_release>(), "Rotations that are replaced on evaluation.")
      .def("with_root", &with_root, nb::arg("i"), nb::call_guard<nb::gil_scoped_release>(),
           "Another Struct as the whole, with what it refers to.")
      .def(
          "to_json", [](const Structure& s) { return to_json(s); },
          nb::call_guard<nb::gil_scoped_release>())
      .def_static(
          "of_json",
          [](const std::string& text, const std::string& name) {
            return read_struct_json(text, name);
          },
          nb::arg("text"), nb::arg("name"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace

void bind_structure(nb::module_& m) {
  nb::class_<Contents>(m, "Contents", "What the body of a Struct holds.")
      .def_ro("elements", &Contents::elements, "Elements of a drawing.")
      .def_ro("segments", &Contents::segments, "Of these.")
      .def_ro("models", &Contents::models, "LAR models.")
      .def_ro("maps", &Contents::maps)
      .def_ro("structs", &Contents::structs, "Structs, each as often as it is referred to.");
  nb::class_<Structure> type(m, "Structure", "A hierarchy of Structs, each stored once.");
  bind_making(type);
  bind_reading(type);
  bind_questions(type);
}

}  // namespace plumbline::python
