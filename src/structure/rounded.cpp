// What a reader that parses numbers as doubles would have.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "plumbline/error.hpp"
#include "structure/placement.hpp"

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

Turn rounded(Turn turn) { return turn; }  // there is none after `without_turns`

bool is_turn(const Struct::Item& item) { return std::holds_alternative<Turn>(item); }

/// The body with successive maps made one where there are rotations among them.
std::vector<Struct::Item> without_turns(std::vector<Struct::Item> body, Rotations& rotations) {
  std::vector<Struct::Item> result, run;
  const auto end_run = [&] {
    if (std::any_of(run.begin(), run.end(), is_turn)) {
      Placement product(2);
      for (const Struct::Item& map : run) product.append(map, rotations);
      run = {product.map(rotations)};
    }
    std::move(run.begin(), run.end(), std::back_inserter(result));
    run.clear();
  };
  for (Struct::Item& item : body) {
    if (!is_map(item)) end_run();
    (is_map(item) ? run : result).push_back(std::move(item));
  }
  end_run();
  return result;
}

}  // namespace

Structure rounded(Structure structure) {
  Rotations rotations(structure.angle_bound);
  for (Struct& s : structure.structs) {
    if (std::any_of(s.body.begin(), s.body.end(), is_turn)) {
      s.body = without_turns(std::move(s.body), rotations);
    }
    for (Struct::Item& item : s.body) {
      item =
          std::visit([](auto& value) -> Struct::Item { return rounded(std::move(value)); }, item);
    }
  }
  return structure;
}

}  // namespace plumbline
