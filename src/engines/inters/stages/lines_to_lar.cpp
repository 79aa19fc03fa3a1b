// From fragments to a 1-complex, section 2.3 (lines2lar).

#include <string>

#include "engines/inters/stages/hash_order.hpp"
#include "geometry/point_d.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// Both ends and the points at the parameters between, in this order.
std::vector<PointD> outline(const Fragment& fragment) {
  std::vector<PointD> points{fragment.segment.a};
  for (const double parameter : fragment.parameters) {
    if (parameter != 0 && parameter != 1) points.push_back(point_at(fragment.segment, parameter));
  }
  points.push_back(fragment.segment.b);
  return points;
}

}  // namespace

Split split(std::span<const Fragment> fragments, const Vcode& vcode) {
  Split result;
  HashTable<std::string> keys;
  HashTable<VertexPair> edges;
  for (const Fragment& fragment : fragments) {
    std::vector<VertexId> vertices;
    for (const PointD& p : outline(fragment)) {
      const auto [vertex, is_new] = keys.insert(vcode.text(p));
      if (is_new) result.model.vertices.push_back(vcode.quantised(p));
      vertices.emplace_back(vertex);
    }
    for (std::size_t i = 1; i < vertices.size(); ++i) edges.insert({vertices[i - 1], vertices[i]});
    // The original emits the pieces found so far after every vertex.
    result.edge_count_with_duplicates += vertices.size() * (vertices.size() - 1) / 2;
  }
  result.model.edges = edges.keys();
  return result;
}

}  // namespace plumbline::inters
