// What `eval` makes of structures.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "plumbline/chains.hpp"
#include "plumbline/error.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline {
namespace {

/// The categories that there are, for who asked for another.
std::string categories(const Structure& structure) {
  std::set<std::string> names;
  for (const Struct& s : structure.structs) names.insert(s.category);
  names.erase("");
  if (names.empty()) return "there are none";
  return fmt::format("there are {}", fmt::join(names, ", "));
}

}  // namespace

Structure only(const Structure& structure, const std::string& category) {
  const auto is_of = [&](const Struct& s) { return s.category == category; };
  if (std::none_of(structure.structs.begin(), structure.structs.end(), is_of)) {
    throw Error(ErrorCode::BadInput, "no structure of this category; " + categories(structure), {},
                category);
  }
  return filter(structure, category);
}

Structure structure_of(LarModel model, bool y_up) {
  Structure structure;
  structure.y_up = y_up;
  structure.structs.push_back({"", "", {std::move(model)}});
  structure.root = StructId(0);
  return structure;
}

LarModel boundary_of_all(const LarModel& model) {
  if (model.dimension == 2) return polygon_boundary(model);
  if (model.cells.size() < 2) {
    throw Error(ErrorCode::BadInput, "the boundary of cells without facets, (V, CV), is not known");
  }
  return boundary_model(model);
}

SegmentSet drawn(const Structure& structure) {
  constexpr std::size_t kSpace = 3;
  if (dimension(structure) != kSpace) return evaluate(structure);
  Affine view(kSpace);
  view(0, 1) = Number(Rational(1, 2));
  view(1, 1) = Number(Rational(1, 4));
  view(1, 2) = Number(Rational(1));
  LarModel model = struct_to_lar(structure, {std::nullopt, true});
  return evaluate(structure_of(embed(apply(view, std::move(model)), -1), structure.y_up));
}

}  // namespace plumbline
