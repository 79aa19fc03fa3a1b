// From components to faces: the one with most edges (larFromLines, section 2.8), or all of them
// (tests 08 and 09 of section 4).

#include <algorithm>
#include <numeric>
#include <tuple>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {

Faces largest_component_faces(const Model& lar, std::span<const std::vector<VertexPair>> components,
                              const Vcode& vcode) {
  const auto largest = std::max_element(
      components.begin(), components.end(),
      [](const auto& first, const auto& second) { return first.size() < second.size(); });
  const HashTable<VertexPair> edges{std::span<const VertexPair>(*largest)};
  return faces_from_components(remove_vertices(lar.vertices, edges.listed(), vcode));
}

Model without_exterior(const Faces& largest) {
  const Lists<VertexId>& faces = largest.model.faces;
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t f, std::size_t g) {
    if (largest.areas[f] != largest.areas[g]) return largest.areas[f] < largest.areas[g];
    return std::lexicographical_compare(faces[f].begin(), faces[f].end(), faces[g].begin(),
                                        faces[g].end());
  });
  Model result{largest.model.vertices, largest.model.edges, {}};
  for (std::size_t i = 0; i + 1 < order.size(); ++i) result.faces.push_back(faces[order[i]]);
  return result;
}

AllComponents all_component_faces(const Model& lar,
                                  std::span<const std::vector<VertexPair>> components,
                                  const Vcode& vcode) {
  if (components.empty()) {
    fail("TypeError", "reduce() of empty sequence with no initial value", "CAT");
  }
  std::vector<VertexPair> edges;
  for (const auto& component : components) {
    edges.insert(edges.end(), component.begin(), component.end());
  }
  AllComponents result{faces_from_components(remove_vertices(lar.vertices, edges, vcode)), {}};
  const std::vector<double>& areas = result.faces.areas;
  const double largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (areas[f] != largest) result.interior.push_back(f);
  }
  return result;
}

}  // namespace plumbline::inters
