#include "round/images.hpp"

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::round_steps {
namespace {

HalfedgeId find(const Incidences& complex, VertexId from, VertexId to) {
  const Edge edge{std::min(from, to), std::max(from, to)};
  const auto at = std::lower_bound(complex.edges.begin(), complex.edges.end(), edge,
                                   [](const Edge& e, const Edge& f) {
                                     return e.tail != f.tail ? e.tail < f.tail : e.head < f.head;
                                   });
  ensure(at != complex.edges.end() && *at == edge, "a chain runs along edges");
  return halfedge(EdgeId(static_cast<std::size_t>(at - complex.edges.begin())), to < from);
}

}  // namespace

Lists<HalfedgeId> edge_images(const Incidences& rounded, const Lists<VertexId>& chains) {
  Lists<HalfedgeId> images;
  std::vector<HalfedgeId> image;
  for (std::size_t e = 0; e < chains.size(); ++e) {
    image.clear();
    for (std::size_t i = 1; i < chains[e].size(); ++i) {
      image.push_back(find(rounded, chains[e][i - 1], chains[e][i]));
    }
    images.push_back(image);
  }
  return images;
}

}  // namespace plumbline::round_steps
