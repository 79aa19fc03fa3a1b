// What a reader that parses numbers as doubles would have.

#include <cmath>
#include <type_traits>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"

namespace plumbline {
namespace {

Number rounded(const Number& value) {
  const double result = nearest_double(value);
  if (!std::isfinite(result)) {
    throw Error(ErrorCode::BadInput, "a number is beyond the largest double", {},
                exact_text(value.rational()));
  }
  return Number(rational_from(result));
}

Affine rounded(Affine map) {
  for (std::size_t row = 0; row < map.dimension(); ++row) {
    for (std::size_t column = 0; column <= map.dimension(); ++column) {
      map(row, column) = rounded(map(row, column));
    }
  }
  return map;
}

Model rounded(Model model) {
  SegmentList segments;
  segments.reserve(model.segments.size());
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const auto numbers = model.segments.numbers(i);
    segments.push_back(NumberPoint{rounded(numbers[0]), rounded(numbers[1])},
                       NumberPoint{rounded(numbers[2]), rounded(numbers[3])});
  }
  model.segments = std::move(segments);
  model.curves.clear();
  return model;
}

LarModel rounded(LarModel model) {
  for (Number& coordinate : model.coordinates) coordinate = rounded(coordinate);
  return model;
}

StructId rounded(StructId id) { return id; }

}  // namespace

Structure rounded(Structure structure) {
  for (Struct& s : structure.structs) {
    for (Struct::Item& item : s.body) {
      item =
          std::visit([](auto& value) -> Struct::Item { return rounded(std::move(value)); }, item);
    }
  }
  return structure;
}

}  // namespace plumbline
