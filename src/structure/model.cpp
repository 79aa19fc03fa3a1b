#include "plumbline/structure/model.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "plumbline/error.hpp"

namespace plumbline {

void check(const LarModel& model, const std::vector<std::string>& files) {
  const auto fail = [&](const std::string& what) {
    const Source& s = model.source;
    throw Error(ErrorCode::BadInput, what,
                {s.file < files.size() ? files[s.file] : std::string(), s.line, s.column}, s.id);
  };
  if (model.dimension == 0) fail("a model of dimension 0");
  if (model.dimension > kMaxDimension) {
    fail("a model of a dimension of more than " + std::to_string(kMaxDimension));
  }
  if (model.coordinates.size() % model.dimension != 0) {
    fail("coordinates of a model that are no whole number of vertices");
  }
  for (const Cells& cells : model.cells) {
    for (const std::uint32_t v : cells.flat()) {
      if (v < model.vertex_count()) continue;
      fail("a cell with vertex " + std::to_string(v) + " of a model with " +
           std::to_string(model.vertex_count()) + " vertices");
    }
  }
}

LarModel lar_model(std::size_t dimension, const std::vector<Rational>& coordinates,
                   std::vector<Cells> cells) {
  LarModel model;
  model.dimension = dimension;
  model.coordinates.assign(coordinates.begin(), coordinates.end());
  model.cells = std::move(cells);
  check(model);
  return model;
}

LarModel lar_model(const Model& model) {
  LarModel result;
  result.source = model.source;
  Cells edges;
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const auto numbers = model.segments.numbers(i);
    const auto tail = static_cast<std::uint32_t>(result.vertex_count());
    result.coordinates.insert(result.coordinates.end(), numbers.begin(), numbers.end());
    edges.push_back(std::array{tail, tail + 1});
  }
  result.cells.push_back(std::move(edges));
  return result;
}

LarModel apply(const Affine& map, LarModel model) {
  if (map.dimension() != model.dimension) {
    throw Error(ErrorCode::BadInput, "a map of dimension " + std::to_string(map.dimension()) +
                                         " for a model of dimension " +
                                         std::to_string(model.dimension));
  }
  std::vector<Number> image(model.dimension);
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    apply(map, model.vertex(v), image);
    std::move(image.begin(), image.end(),
              model.coordinates.begin() + static_cast<std::ptrdiff_t>(v * model.dimension));
  }
  return model;
}

LarModel embed(const LarModel& model, int k) {
  const long to = static_cast<long>(model.dimension) + k;
  if (to <= 0) throw Error(ErrorCode::BadInput, "a projection that leaves no dimension");
  if (to > static_cast<long>(kMaxDimension)) {
    throw Error(ErrorCode::Limit, "a dimension of more than " + std::to_string(kMaxDimension));
  }
  LarModel result{model.source, static_cast<std::size_t>(to), {}, model.cells};
  const std::size_t kept = std::min(model.dimension, result.dimension);
  result.coordinates.resize(model.vertex_count() * result.dimension);
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    const auto from = model.vertex(v);
    std::copy_n(from.begin(), kept,
                result.coordinates.begin() + static_cast<std::ptrdiff_t>(v * result.dimension));
  }
  return result;
}

}  // namespace plumbline
