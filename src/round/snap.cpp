// Every link of a chain is an edge of the result, once, however many chains have it. The engine
// arranges the links as it would any segments; that it finds the links and the centres themselves
// and nothing new proves that they meet nowhere else.

#include "round/snap.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::round_steps {
namespace {

bool precedes(const Edge& e, const Edge& f) {
  return e.tail != f.tail ? e.tail < f.tail : e.head < f.head;
}

/// A link of a chain, with the exact edge that it is part of.
struct Link {
  Edge edge;
  EdgeId part_of;
};

std::vector<Link> links(const Lists<VertexId>& chains) {
  std::vector<Link> result;
  for (std::size_t e = 0; e < chains.size(); ++e) {
    for (std::size_t i = 1; i < chains[e].size(); ++i) {
      const auto [tail, head] = std::minmax(chains[e][i - 1], chains[e][i]);
      result.push_back({{tail, head}, EdgeId(e)});
    }
  }
  std::sort(result.begin(), result.end(), [](const Link& k, const Link& l) {
    return k.edge != l.edge ? precedes(k.edge, l.edge) : k.part_of < l.part_of;
  });
  return result;
}

std::vector<Point> on_grid(const std::vector<Point>& centres, const Rational& spacing) {
  std::vector<Point> result;
  result.reserve(centres.size());
  for (const Point& p : centres) result.push_back({p.x * spacing, p.y * spacing});
  return result;
}

SegmentSet drawing(const std::vector<Point>& points, const std::vector<Edge>& edges) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  std::vector<bool> has_edge(points.size());
  for (const auto& [tail, head] : edges) {
    set.add({points[tail], points[head]}, source);
    has_edge[tail] = has_edge[head] = true;
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!has_edge[v]) set.add_point(points[v], source);
  }
  return set;
}

}  // namespace

Snapped snapped(const ExactComplex& exact, const HotPixels& pixels, const Rational& spacing,
                const ArrangeOptions& options) {
  Snapped result;
  for (const Edge& edge : exact.edges) result.chains.push_back(pixels.met_by(edge));
  std::vector<Edge> edges;
  Lists<SegmentId> sources;
  const std::vector<Link> all = links(result.chains);
  std::vector<SegmentId> covering;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    covering.clear();
    for (end = begin; end < all.size() && all[end].edge == all[begin].edge; ++end) {
      const auto more = exact.edge_sources[all[end].part_of];
      covering.insert(covering.end(), more.begin(), more.end());
    }
    std::sort(covering.begin(), covering.end());
    covering.erase(std::unique(covering.begin(), covering.end()), covering.end());
    edges.push_back(all[begin].edge);
    sources.push_back(covering);
  }
  const std::vector<Point> points = on_grid(pixels.places().points, spacing);
  result.complex = arrange(drawing(points, edges), ExactEngine::Bucket, options);
  ensure(result.complex.vertices == PointList(points) && result.complex.edges == edges,
         "snap rounded edges meet only at the centres of hot pixels");
  result.complex.edge_sources = std::move(sources);
  return result;
}

}  // namespace plumbline::round_steps
