// Segments with their sources; what was refused, replaced and is to be said of them.

#include "plumbline/geometry.hpp"

#include <nanobind/stl/tuple.h>

#include <tuple>

#include "core.hpp"
#include "plumbline/geometry/extent.hpp"
#include "plumbline/geometry/layers.hpp"

namespace plumbline::python {
namespace {

using Doubles = nb::ndarray<const double, nb::shape<-1, 4>, nb::c_contig, nb::device::cpu>;
using PointDoubles = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using RingRows = nb::ndarray<const std::uint32_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

/// What segments of an array are parts of.
struct Items {
  std::string title;                ///< takes the place of a file's name
  std::string element;              ///< what an item is: "row", "geometry"
  std::optional<Numbers> item;      ///< per segment; none: each is an item
  std::size_t count = 0;            ///< of items
  std::vector<std::string> ids;     ///< per item, or none
  std::vector<std::string> layers;  ///< the same
  std::optional<RingRows> rings;    ///< rows of first segment, count, role
};

SegmentSet with_sources(const Items& items) {
  SegmentSet set;
  set.y_up = true;
  const std::uint32_t file = set.add_file(items.title);
  set.sources.reserve(items.count);
  for (std::size_t i = 0; i < items.count; ++i) {
    set.add_source({.file = file,
                    .line = static_cast<std::uint32_t>(i + 1),
                    .element = items.element,
                    .id = items.ids.empty() ? std::string() : items.ids[i],
                    .path = {},
                    .layer = items.layers.empty() ? std::string() : items.layers[i]});
  }
  return set;
}

/// Adds segments one by one, which `add(set, i, source)` does; those that are refused are in no
/// ring.
template <class Add>
SegmentSet with_segments(std::size_t count, const Items& items, const Add& add) {
  SegmentSet set = with_sources(items);
  set.segments.reserve(count);
  set.segment_source.reserve(count);
  std::vector<std::uint32_t> before{0};  // kept segments before each one
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t item = items.item ? items.item->data()[i] : i;
    if (item >= items.count) throw Error(ErrorCode::BadInput, "an item that is not there");
    add(set, i, SourceId(item));
    if (items.rings) before.push_back(static_cast<std::uint32_t>(set.segments.size()));
  }
  for (std::size_t r = 0; items.rings && r < items.rings->shape(0); ++r) {
    const std::uint32_t* row = items.rings->data() + 3 * r;
    if (row[2] > 3 || row[0] > count || row[1] > count - row[0]) {
      throw Error(ErrorCode::BadInput, "a ring of segments that are not there");
    }
    set.rings.push_back(
        {before[row[0]], before[row[0] + row[1]] - before[row[0]], static_cast<RingRole>(row[2])});
  }
  return set;
}

SegmentSet of_doubles(const Doubles& coords, const Items& items, bool decimals) {
  const double* c = coords.data();
  return with_segments(coords.shape(0), items, [&](SegmentSet& set, std::size_t i, SourceId s) {
    const double* row = c + 4 * i;
    const bool finite = std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]) &&
                        std::isfinite(row[3]);
    if (!decimals || !finite) {
      set.add(PointD{row[0], row[1]}, PointD{row[2], row[3]}, s);
      return;
    }
    const auto number = [&](int k) { return parse_number(shortest_text(row[k])); };
    set.add(NumberPoint{number(0), number(1)}, NumberPoint{number(2), number(3)}, s);
  });
}

SegmentSet of_texts(const std::vector<std::string>& texts, const Items& items) {
  return with_segments(texts.size() / 4, items, [&](SegmentSet& set, std::size_t i, SourceId s) {
    const auto number = [&](std::size_t k) { return parse_number(texts[4 * i + k]); };
    set.add(NumberPoint{number(0), number(1)}, NumberPoint{number(2), number(3)}, s);
  });
}

void add_points(SegmentSet& set, const std::vector<std::string>& texts, std::string title) {
  if (texts.empty()) return;
  const std::uint32_t file = set.add_file(std::move(title));
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) {
    const SourceId source = set.add_source({.file = file,
                                            .line = static_cast<std::uint32_t>(i / 2 + 1),
                                            .element = "point",
                                            .id = {},
                                            .path = {}});
    set.add_point({parse_decimal(texts[i]), parse_decimal(texts[i + 1])}, source);
  }
}

DoubleArray coords_of(const SegmentSet& set) {
  std::vector<double> coords;
  {
    const nb::gil_scoped_release release;
    coords.reserve(4 * set.segments.size());
    for (std::size_t i = 0; i < set.segments.size(); ++i) {
      for (const Number& number : set.segments.numbers(i)) {
        coords.push_back(nearest_double(number));
      }
    }
  }
  return array(std::move(coords), 4);
}

/// A segment as ax, ay, bx, by.
std::tuple<Rational, Rational, Rational, Rational> exact_segment(const SegmentSet& set,
                                                                 std::size_t i) {
  if (i >= set.segments.size()) throw nb::index_error("there are fewer segments");
  const Segment s = set.segments[i];
  return {s.a.x, s.a.y, s.b.x, s.b.y};
}

/// An element without the name of its file.
std::string line_of(const Source& source) { return line_text(to_text(source, {})); }

template <class T>
void bind_item(nb::class_<T> type, const char* what, std::string T::*member, const char* doc) {
  type.def_ro("source", &T::source, "The element that it is about.").def_ro(what, member, doc);
  type.def("__repr__", [member](const T& item) {
    return "<" + line_of(item.source) + ": " + line_text(item.*member) + ">";
  });
  define_equality(type);
}

void bind_items(nb::module_& m) {
  nb::class_<Source> source(m, "Source", "The element of a drawing that something came from.");
  source.def_ro("file", &Source::file, "Index into the names of files.")
      .def_ro("line", &Source::line,
              "Its line in the file, or its number in an array, from 1; 0: not known.")
      .def_ro("column", &Source::column, "From 1; 0: not known.")
      .def_ro("element", &Source::element, "What it is in the format: \"LINE\", \"row\", ...")
      .def_ro("id", &Source::id, "Its id, or \"\".")
      .def_ro("path", &Source::path, "Names of the groups or layers above it.")
      .def_ro("layer", &Source::layer, "Its layer, or \"\".");
  source.def("__repr__", [](const Source& s) { return "<Source: " + line_of(s) + ">"; });
  define_equality(source);
  nb::class_<Rejected> rejected(m, "Rejected",
                                "An item of the input that takes no part in the result.");
  bind_item(rejected, "reason", &Rejected::reason, "Why.");
  rejected.def_ro("text", &Rejected::text, "The text that it is about.")
      .def_ro("harmless", &Rejected::harmless, "Whether no lines were lost with it.");
  nb::class_<Remark> remark(m, "Remark", "What is to be said of an item that was drawn.");
  bind_item(remark, "what", &Remark::what, "In a sentence.");
  remark.def_ro("text", &Remark::text, "The text that it is about.");
  nb::class_<Replacement> replacement(
      m, "Replacement", "A number that was replaced on the way to exact coordinates.");
  bind_item(replacement, "what", &Replacement::what, "What was replaced: \"rotate(30)\".");
  replacement.def_ro("bound", &Replacement::bound, "By how much at most: \"1e-15 rad\".");
  nb::class_<Label>(m, "Label", "A text of the drawing, or the name of an element.")
      .def_ro("source", &Label::source, "Index into the sources.")
      .def_ro("text", &Label::text, "What it says.")
      .def_ro("place", &Label::place, "Where; None: a name of its element.")
      .def_ro("height", &Label::height, "Of its letters; 0: not known.")
      .def("__repr__", [](const Label& l) { return "<Label: " + line_text(l.text) + ">"; });
  nb::class_<Layer>(m, "Layer", "A layer that the drawing declares.")
      .def_ro("name", &Layer::name, "Its name.")
      .def_ro("rgb", &Layer::rgb, "Its colour, 0xRRGGBB; None: not known.")
      .def_ro("hidden", &Layer::hidden, "Whether it is off, frozen or not printed.")
      .def("__repr__", [](const Layer& l) {
        return "<Layer: " + line_text(l.name) + (l.hidden ? ", hidden>" : ">");
      });
  nb::class_<LengthUnit>(m, "LengthUnit", "A unit of length.")
      .def(nb::init<std::string, Rational>(), nb::arg("name"), nb::arg("metres"))
      .def_ro("name", &LengthUnit::name, "\"mm\", \"in\", ...")
      .def_ro("metres", &LengthUnit::metres, "In metres, exactly.")
      .def("__repr__", [](const LengthUnit& u) {
        return "<LengthUnit: " + u.name + ", " + exact_text(u.metres) + " m>";
      });
}

void bind_making(nb::class_<SegmentSet>& set) {
  set.def_static("of_doubles", &of_doubles, nb::arg("coords"), nb::arg("items"),
                 nb::arg("decimals"), nb::call_guard<nb::gil_scoped_release>(),
                 "Segments (n, 4): the numbers that the doubles are, or that they print as.")
      .def_static("of_texts", &of_texts, nb::arg("texts"), nb::arg("items"),
                  nb::call_guard<nb::gil_scoped_release>(),
                  "Segments of four texts each: decimals or fractions \"p/q\".")
      .def("add_points", &add_points, nb::arg("texts"), nb::arg("title"),
           "Adds isolated points, two texts each.")
      .def(
          "reject",
          [](SegmentSet& self, std::size_t item, std::string reason, bool harmless) {
            self.rejected.push_back({self.sources.at(item), std::move(reason), {}, harmless});
          },
          nb::arg("item"), nb::arg("reason"), nb::arg("harmless"), "Lists an item as rejected.")
      .def(
          "set_frame",
          [](SegmentSet& self, std::string crs, bool y_up) {
            self.crs = std::move(crs);
            self.y_up = y_up;
          },
          nb::arg("crs"), nb::arg("y_up"))
      .def(
          "set_unit", [](SegmentSet& self, LengthUnit unit) { self.unit = std::move(unit); },
          nb::arg("unit"))
      .def(
          "on_layers",
          [](const SegmentSet& self, const std::vector<std::string>& patterns) {
            return on_layers(self, patterns);
          },
          nb::arg("patterns"), "Those segments alone that lie on layers of these names.");
}

void bind_reading(nb::class_<SegmentSet>& set) {
  set.def("__len__", [](const SegmentSet& self) { return self.segments.size(); })
      .def("coords", &coords_of, "Nearest doubles, (n, 4).")
      .def("segment", &exact_segment, nb::arg("i"), "ax, ay, bx, by.")
      .def(
          "item",
          [](nb::handle self) {
            return view(nb::cast<const SegmentSet&>(self).segment_source, self);
          },
          nb::sig("def item(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "Per segment the index of its source.")
      .def("source_count", [](const SegmentSet& self) { return self.sources.size(); })
      .def(
          "source", [](const SegmentSet& self, std::size_t i) { return self.sources.at(i); },
          nb::arg("i"))
      .def(
          "source_text",
          [](const SegmentSet& self, std::size_t i) {
            return line_text(to_text(self.sources.at(i), self.files));
          },
          nb::arg("i"))
      .def(
          "place_text",
          [](const SegmentSet& self, const Source& source) {
            return line_text(to_text(source, self.files));
          },
          nb::arg("source"))
      .def_ro("points", &SegmentSet::points)
      .def_ro("files", &SegmentSet::files)
      .def_ro("labels", &SegmentSet::labels)
      .def_ro("layers", &SegmentSet::layers)
      .def_ro("rejected", &SegmentSet::rejected)
      .def_ro("remarks", &SegmentSet::remarks)
      .def_ro("ledger", &SegmentSet::ledger)
      .def_ro("crs", &SegmentSet::crs)
      .def_ro("unit", &SegmentSet::unit)
      .def_ro("authored_unit", &SegmentSet::authored_unit)
      .def_ro("y_up", &SegmentSet::y_up)
      .def("stray_count", [](const SegmentSet& self) { return extent(self).stray.size(); })
      .def(
          "extent",
          [](const SegmentSet& self) {
            const Extent box = extent(self);
            return nb::make_tuple(box.low.x, box.low.y, box.high.x, box.high.y);
          },
          nb::sig("def extent(self) -> tuple[float, float, float, float]"),
          "The box of what is not stray.");
}

}  // namespace

void bind_geometry(nb::module_& m) {
  bind_items(m);
  nb::class_<Items>(m, "Items", "What the segments of an array are parts of.")
      .def(nb::init<std::string, std::string, std::optional<Numbers>, std::size_t,
                    std::vector<std::string>, std::vector<std::string>, std::optional<RingRows>>(),
           nb::arg("title"), nb::arg("element"), nb::arg("item").none(), nb::arg("count"),
           nb::arg("ids"), nb::arg("layers"), nb::arg("rings").none());
  nb::class_<SegmentSet> set(m, "SegmentSet", "Exact segments, each with its source.");
  bind_making(set);
  bind_reading(set);
  bind_state(set);
}

}  // namespace plumbline::python
