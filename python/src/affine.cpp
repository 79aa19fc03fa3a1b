// Affine maps of any dimension, and rotations that are not replaced yet.

#include "plumbline/structure/affine.hpp"

#include <nanobind/stl/pair.h>

#include <array>
#include <string>
#include <utility>

#include "core.hpp"
#include "plumbline/structure.hpp"

namespace plumbline::python {
namespace {

using Texts = std::vector<std::string>;

std::vector<Rational> rationals(const Texts& texts) {
  std::vector<Rational> values;
  values.reserve(texts.size());
  for (const std::string& text : texts) values.push_back(parse_decimal(text));
  return values;
}

/// Rows of A and t, one after the other.
Affine affine_of(std::size_t dimension, const Texts& texts) {
  Affine map(dimension);
  if (texts.size() != dimension * (dimension + 1)) {
    throw Error(ErrorCode::BadInput, "a map of d dimensions has d (d + 1) entries");
  }
  for (std::size_t row = 0; row < dimension; ++row) {
    for (std::size_t column = 0; column <= dimension; ++column) {
      map(row, column) = parse_number(texts[row * (dimension + 1) + column]);
    }
  }
  return map;
}

std::vector<Rational> entries(const Affine& map) {
  std::vector<Rational> values;
  for (const Number& entry : map.entries()) values.push_back(entry.rational());
  return values;
}

std::vector<Rational> applied(const Affine& map, const Texts& point) {
  if (point.size() != map.dimension()) {
    throw Error(ErrorCode::BadInput, "a point has as many coordinates as the map has dimensions",
                {}, std::to_string(point.size()) + ", not " + std::to_string(map.dimension()));
  }
  std::vector<Number> from, to(point.size());
  for (const std::string& text : point) from.push_back(parse_number(text));
  apply(map, from, to);
  std::vector<Rational> image;
  for (const Number& coordinate : to) image.push_back(coordinate.rational());
  return image;
}

/// The map, and by how many radians its angle may be another one.
std::pair<Affine, Rational> with_bound(ApproximateAffine map) {
  return {std::move(map.map), std::move(map.bound)};
}

}  // namespace

void bind_affine(nb::module_& m) {
  nb::class_<Affine> type(m, "Affine", "An exact affine map.");
  type.def_static("of_texts", &affine_of, nb::arg("dimension"), nb::arg("texts"),
                  "Of the rows of A and t, one after the other.")
      .def_static(
          "translation", [](const Texts& by) { return translation(rationals(by)); }, nb::arg("by"))
      .def_static(
          "scaling", [](const Texts& factors) { return scaling(rationals(factors)); },
          nb::arg("factors"))
      .def_static(
          "rotation",
          [](const std::string& degrees, double bound) {
            return with_bound(rotation(parse_decimal(degrees), bound));
          },
          nb::arg("degrees"), nb::arg("bound"), "Of the plane; and its bound, in radians.")
      .def_static(
          "rotation_in_radians",
          [](const std::string& radians, double bound) {
            return with_bound(rotation_in_radians(parse_decimal(radians), bound));
          },
          nb::arg("radians"), nb::arg("bound"), "Of the plane; and its bound, in radians.")
      .def_static(
          "rotation_in_space",
          [](const std::string& x, const std::string& y, const std::string& z, double bound) {
            const std::array<Rational, 3> axis{parse_decimal(x), parse_decimal(y),
                                               parse_decimal(z)};
            return with_bound(rotation_in_space(axis, bound));
          },
          nb::arg("x"), nb::arg("y"), nb::arg("z"), nb::arg("bound"),
          "About this vector, by its length; and its bound, in radians.")
      .def_prop_ro("dimension", &Affine::dimension, "Of the space that it maps.")
      .def("entries", &entries, "The rows of A and t, one after the other.")
      .def("applied", &applied, nb::arg("point"), "The image of a point.")
      .def("after", &compose, nb::arg("inner"), "The map that does `inner` first.")
      .def("inverse", [](const Affine& map) { return inverse(map); })
      .def(
          "embedded", [](const Affine& map, int k) { return embed(map, k); }, nb::arg("k"),
          "In a space of k more dimensions.");
  define_equality(type);
  nb::class_<Turn>(m, "Turn", "A rotation of the plane by degrees, which is not replaced yet.")
      .def_ro("degrees", &Turn::degrees, "From +x towards +y.");
}

}  // namespace plumbline::python
