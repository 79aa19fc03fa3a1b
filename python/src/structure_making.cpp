// How Python makes a Structure: Struct by Struct, item by item.

#include "structure_making.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "plumbline/geometry.hpp"

namespace plumbline::python {
namespace {

Struct& struct_at(Structure& structure, std::size_t i) {
  if (i >= structure.structs.size()) throw nb::index_error("there are fewer structs");
  return structure.structs[i];
}

template <class T>
void join(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// What a structure or lines say besides their items; `files` is how many files were there before.
template <class Part>
void join_losses(Structure& structure, const Part& part, std::uint32_t files) {
  const auto join_sources = [files](auto& all, auto more) {
    for (auto& item : more) item.source.file += files;
    join(all, more);
  };
  join_sources(structure.rejected, part.rejected);
  join_sources(structure.remarks, part.remarks);
  join_sources(structure.ledger, part.ledger);
  for (const Layer& layer : part.layers) {
    if (std::ranges::find(structure.layers, layer.name, &Layer::name) == structure.layers.end()) {
      structure.layers.push_back(layer);
    }
  }
}

/// The frame of a part must be that of the whole.
template <class Part>
void join_frame(Structure& structure, const Part& part) {
  if (structure.crs.empty()) structure.crs = part.crs;
  if (!part.crs.empty() && part.crs != structure.crs) {
    throw Error(ErrorCode::BadInput, "parts have different reference systems", {}, part.crs);
  }
  if (!structure.unit) structure.unit = part.unit;
  if (part.unit && part.unit->metres != structure.unit->metres) {
    throw Error(ErrorCode::BadInput, "parts have different units of length", {}, part.unit->name);
  }
}

/// Adds all Structs of another structure; returns what its numbers of Structs grow by.
std::size_t append(Structure& structure, const Structure& part) {
  const std::size_t first = structure.structs.size();
  const auto files = static_cast<std::uint32_t>(structure.files.size());
  join_frame(structure, part);
  join(structure.files, part.files);
  join_losses(structure, part, files);
  for (Struct s : part.structs) {
    for (Struct::Item& item : s.body) {
      if (auto* id = std::get_if<StructId>(&item)) *id = StructId(*id + first);
      if (auto* turn = std::get_if<Turn>(&item)) turn->source.file += files;
      if (auto* element = std::get_if<Model>(&item)) element->source.file += files;
      if (auto* model = std::get_if<LarModel>(&item)) model->source.file += files;
    }
    structure.structs.push_back(std::move(s));
  }
  return first;
}

using LabelsOf = std::map<SourceId, std::vector<Model::Text>>;

LabelsOf labels_by_source(const SegmentSet& lines) {
  LabelsOf labels;
  for (const Label& label : lines.labels) {
    Model::Text text{label.text, std::nullopt, 0, label.height};
    if (label.place) text.place = NumberPoint{label.place->x, label.place->y};
    labels[label.source].push_back(std::move(text));
  }
  return labels;
}

/// The segments from `first` on that are of one source.
Model element_at(const SegmentSet& lines, std::size_t first) {
  Model element;
  const SourceId source = lines.segment_source[first];
  element.source = lines.sources[source];
  for (std::size_t i = first; i < lines.segments.size() && lines.segment_source[i] == source; ++i) {
    const auto c = lines.segments.numbers(i);
    element.segments.push_back({c[0], c[1]}, {c[2], c[3]});
  }
  return element;
}

/// Rings that lie in [first, first + element's segments).
void take_rings(Model& element, const SegmentSet& lines, std::size_t first, std::size_t& ring) {
  const std::size_t end = first + element.segments.size();
  for (; ring < lines.rings.size() && lines.rings[ring].first < end; ++ring) {
    Ring taken = lines.rings[ring];
    if (taken.first < first || taken.first + taken.count > end) continue;
    taken.first -= static_cast<std::uint32_t>(first);
    element.rings.push_back(taken);
  }
}

/// Adds lines to a body, an element for each run of segments of one source.
void add_lines(Structure& structure, std::size_t i, const SegmentSet& lines) {
  if (!lines.points.empty()) {
    throw Error(ErrorCode::BadInput, "lines with isolated points cannot be part of a Struct");
  }
  Struct& s = struct_at(structure, i);
  const auto files = static_cast<std::uint32_t>(structure.files.size());
  join_frame(structure, lines);
  join(structure.files, lines.files);
  join_losses(structure, lines, files);
  LabelsOf labels = labels_by_source(lines);
  std::size_t ring = 0;
  const auto add = [&](Model element, SourceId source) {
    const auto texts = labels.find(source);
    if (texts != labels.end()) {
      element.labels = std::move(texts->second);
      labels.erase(texts);
    }
    element.source.file += files;
    s.body.emplace_back(std::move(element));
  };
  for (std::size_t first = 0; first < lines.segments.size();) {
    Model element = element_at(lines, first);
    const std::size_t count = element.segments.size();
    take_rings(element, lines, first, ring);
    add(std::move(element), lines.segment_source[first]);
    first += count;
  }
  while (!labels.empty()) {
    Model element;
    const SourceId source = labels.begin()->first;
    element.source = lines.sources[source];
    add(std::move(element), source);
  }
}

void add_map(Structure& structure, std::size_t i, const Affine& map, const std::string& what,
             const Rational& bound) {
  struct_at(structure, i).body.emplace_back(map);
  if (sgn(bound) == 0) return;
  structure.ledger.push_back({{.element = "r", .id = {}, .path = {}},
                              what,
                              shortest_text(nearest_double(bound)) + " rad"});
}

}  // namespace

void bind_making(nb::class_<Structure>& type) {
  type.def(
          "__init__",
          [](Structure* self, const std::string& file) {
            new (self) Structure();
            self->files.push_back(file);
            self->y_up = true;
          },
          nb::arg("file"))
      .def(
          "add_struct",
          [](Structure& s, std::string name, std::string category) {
            s.structs.push_back({std::move(name), std::move(category), {}});
            return s.structs.size() - 1;
          },
          nb::arg("name"), nb::arg("category"), "Adds an empty Struct; returns its number.")
      .def(
          "set_root", [](Structure& s, std::size_t i) { s.root = StructId(i); }, nb::arg("i"))
      .def("add_map", &add_map, nb::arg("i"), nb::arg("map"), nb::arg("what"), nb::arg("bound"),
           "Adds a map to a body; where its bound is not 0, the ledger says what it stands for.")
      .def(
          "add_turn",
          [](Structure& s, std::size_t i, const Rational& degrees) {
            struct_at(s, i).body.push_back(
                rotation_item(degrees, {.element = "r", .id = {}, .path = {}}));
          },
          nb::arg("i"), nb::arg("degrees"))
      .def(
          "add_model",
          [](Structure& s, std::size_t i, LarModel model) {
            if (model.source.element.empty()) model.source.element = "model";
            struct_at(s, i).body.emplace_back(std::move(model));
          },
          nb::arg("i"), nb::arg("model"))
      .def(
          "add_element",
          [](Structure& s, std::size_t i, Model element) {
            element.source.file = element.source.line = element.source.column = 0;
            for (Model::Row& row : element.rows) row.line = row.column = 0;
            struct_at(s, i).body.emplace_back(std::move(element));
          },
          nb::arg("i"), nb::arg("element"), "Adds an element, which has no place any more.")
      .def("add_lines", &add_lines, nb::arg("i"), nb::arg("lines"))
      .def(
          "add_reference",
          [](Structure& s, std::size_t i, std::size_t j) {
            struct_at(s, i).body.emplace_back(StructId(j));
          },
          nb::arg("i"), nb::arg("j"))
      .def("append", &append, nb::arg("part"),
           "Adds all Structs of another one; returns what their numbers grow by.");
}

}  // namespace plumbline::python
