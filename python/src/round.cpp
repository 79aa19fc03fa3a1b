// Rounded complexes, proven to be valid, and what rounding changed.

#include "plumbline/round.hpp"

#include <string>

#include "core.hpp"
#include "plumbline/features.hpp"

namespace plumbline::python {
namespace {

const char* name_of(RoundingMethod method) {
  switch (method) {
    case RoundingMethod::NearestDoubles:
      return "nearest doubles";
    case RoundingMethod::NearestPoints:
      return "nearest points";
    case RoundingMethod::SnapRounded:
      break;
  }
  return "snap rounded";
}

const Rounding& rounding_of(nb::handle self) { return nb::cast<const Rounding&>(self); }

void bind_rounding(nb::module_& m) {
  nb::class_<Rounding>(m, "Rounding", "A complex with rounded coordinates, proven to be valid.")
      .def_prop_ro("method", [](const Rounding& r) { return name_of(r.method); })
      .def_ro("spacing", &Rounding::spacing)
      .def_ro("complex", &Rounding::complex)
      .def_ro("valid_as_doubles", &Rounding::valid_as_doubles)
      .def("has_same_incidences", &Rounding::has_same_incidences)
      .def("note", &note_of, "What is to be known of the numbers, in words.")
      .def("vertex_image",
           [](nb::handle self) { return view(rounding_of(self).vertex_image, self); })
      .def("edge_image", [](nb::handle self) { return view(rounding_of(self).edge_image, self); })
      .def("face_origin",
           [](nb::handle self) { return view(rounding_of(self).face_origin, self); });
}

/// "<RoundingChanges: 3 vertices moved, 1 edges bent>".
std::string text_of(const RoundingChanges& c) {
  std::string text;
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + what;
  };
  say(c.moved_vertices.size(), " vertices moved");
  say(c.merged_vertices.size(), " vertices of several");
  say(c.bent_edges.size(), " edges bent");
  say(c.merged_edges.size(), " edges of several");
  say(c.vanished_edges.size(), " edges vanished");
  say(c.vanished_faces.size(), " faces vanished");
  say(c.split_faces.size(), " faces split");
  return "<RoundingChanges: " + (text.empty() ? "none" : text) + ">";
}

void bind_changes(nb::module_& m) {
  using Changes = RoundingChanges;
  nb::class_<Changes> type(m, "RoundingChanges",
                           "What rounding did, cell by cell, ascending; distances are exact.");
  nb::class_<Changes::Movement>(type, "Movement", "A vertex that moved.")
      .def_ro("vertex", &Changes::Movement::vertex, "Of the exact arrangement.")
      .def_ro("squared_distance", &Changes::Movement::squared_distance);
  nb::class_<Changes::MergedVertices>(type, "MergedVertices", "Vertices that became one.")
      .def_ro("into", &Changes::MergedVertices::into, "Of the rounded arrangement.")
      .def_prop_ro(
          "from_", [](const Changes::MergedVertices& x) { return x.from; },
          "Of the exact arrangement, two or more.");
  nb::class_<Changes::MergedEdges>(type, "MergedEdges", "Edges that became one.")
      .def_ro("into", &Changes::MergedEdges::into, "Of the rounded arrangement.")
      .def_prop_ro(
          "from_", [](const Changes::MergedEdges& x) { return x.from; },
          "Of the exact arrangement, two or more.");
  nb::class_<Changes::Bend>(type, "Bend", "An edge that is led through vertices near it.")
      .def_ro("edge", &Changes::Bend::edge, "Of the exact arrangement.")
      .def_ro("squared_distance", &Changes::Bend::squared_distance,
              "Of those vertices from it, the largest.");
  nb::class_<Changes::SplitFace>(type, "SplitFace", "A face that fell into parts.")
      .def_ro("face", &Changes::SplitFace::face, "Of the exact arrangement.")
      .def_ro("into", &Changes::SplitFace::into, "Of the rounded arrangement.");
  type.def_ro("moved_vertices", &Changes::moved_vertices)
      .def_ro("merged_vertices", &Changes::merged_vertices)
      .def_ro("merged_edges", &Changes::merged_edges)
      .def_ro("bent_edges", &Changes::bent_edges)
      .def_ro("vanished_edges", &Changes::vanished_edges)
      .def_ro("vanished_faces", &Changes::vanished_faces)
      .def_ro("split_faces", &Changes::split_faces)
      .def("largest_squared_movement", &Changes::largest_squared_movement)
      .def("largest_squared_bend", &Changes::largest_squared_bend)
      .def("__repr__", &text_of);
}

}  // namespace

void bind_round(nb::module_& m) {
  bind_rounding(m);
  bind_changes(m);
  m.def(
      "safely_rounded",
      [](const ExactComplex& complex, std::optional<int> decimals, std::size_t threads,
         nb::object progress) {
        Progress told(std::move(progress));
        return told.run([&](const std::function<bool(double)>& callback) {
          return safely_rounded(complex, {decimals}, {.threads = threads, .progress = callback});
        });
      },
      nb::arg("complex"), nb::arg("decimals").none(), nb::arg("threads"),
      nb::arg("progress").none());
  m.def(
      "is_kept_by_simple_rounding",
      [](const ExactComplex& complex, std::optional<int> decimals) {
        return is_kept_by_simple_rounding(complex, {decimals});
      },
      nb::arg("complex"), nb::arg("decimals").none(), nb::call_guard<nb::gil_scoped_release>());
  m.def("rounding_changes", &changes, nb::arg("complex"), nb::arg("rounding"),
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python
